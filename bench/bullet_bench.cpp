// Bullet's soft body on the same sheet of 33 x 33 vertices: the same springs as links, the same mass, the same two
// pins.
#include "bench/cloths.hpp"
#include "bench/suite.hpp"

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

namespace drape::bench {
namespace {

constexpr int batch = 10;

btVector3 toBullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

class BulletCloth {
 public:
  BulletCloth(ModelPtr model, int iterations)
      : model_(std::move(model)),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    const btVector3 gravity(0.0F, -9.81F, 0.0F);
    world_.setGravity(gravity);
    world_.getWorldInfo().m_gravity = gravity;
    start_ = waving(*model_);
    std::vector<btVector3> places;
    std::vector<btScalar> masses;
    for (std::size_t v = 0; v < start_.positions.size(); ++v) {
      places.push_back(toBullet(start_.positions[v]));
      masses.push_back(model_->pinned[v] ? 0.0F : static_cast<btScalar>(model_->vertexMass[v]));
    }
    body_ = std::make_unique<btSoftBody>(&world_.getWorldInfo(), model_->vertexCount(), places.data(), masses.data());
    for (const sim::Spring& spring : model_->springs) {
      body_->appendLink(spring.a, spring.b);
      body_->m_links[body_->m_links.size() - 1].m_rl = static_cast<btScalar>(spring.restLength);
    }
    body_->updateLinkConstants();
    body_->m_cfg.piterations = iterations;
    body_->m_cfg.collisions = 0;
    body_->m_cfg.kDP = 0.0F;
    world_.addSoftBody(body_.get());
  }
  BulletCloth(const BulletCloth&) = delete;
  BulletCloth& operator=(const BulletCloth&) = delete;
  ~BulletCloth() { world_.removeSoftBody(body_.get()); }

  void restart() {
    for (int v = 0; v < body_->m_nodes.size(); ++v) {
      btSoftBody::Node& node = body_->m_nodes[v];
      node.m_x = toBullet(start_.positions[static_cast<std::size_t>(v)]);
      node.m_q = node.m_x;
      node.m_v = toBullet(start_.velocities[static_cast<std::size_t>(v)]);
      node.m_f = btVector3(0.0F, 0.0F, 0.0F);
    }
  }

  void steps(int count) {
    for (int i = 0; i < count; ++i) {
      world_.stepSimulation(static_cast<btScalar>(stillAir().timeStep), 0);
    }
  }

 private:
  ModelPtr model_;
  sim::ClothState start_;
  btSoftBodyRigidBodyCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btSoftRigidDynamicsWorld world_;
  std::unique_ptr<btSoftBody> body_;
};

}  // namespace

void addBulletGroup(Suite& suite) {
  for (const int iterations : {1, 10}) {
    const std::string name = "Bullet, " + std::to_string(iterations) + (iterations == 1 ? " iteration" : " iterations");
    suite.add({"Bullet", name, "us/step"}, [iterations]() -> Batch {
      auto cloth = std::make_shared<BulletCloth>(grid(33), iterations);
      return {batch, [cloth] {
                cloth->restart();
                return threadSeconds([&] { cloth->steps(batch); });
              }};
    });
    suite.addRatio({"Bullet", name + " / full step", "Bullet/" + name, "step/full step, float"});
  }
}

}  // namespace drape::bench
