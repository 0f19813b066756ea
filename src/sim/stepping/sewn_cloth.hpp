#pragma once

#include "sim/contact/contact_parameters.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/seams.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/solvers/step_parameters.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::sim {

/// A cloth with seams. Its model changes in the course of a simulation: at first the pieces are apart, and each seam is
/// welded as soon as all its pairs are close. Which seams are welded follows from the positions (isWelded), so that a
/// copy of a state is still a checkpoint.
class SewnCloth {
 public:
  /// Another cloth, with no seam welded. @param seams of its vertices; null: none
  void use(std::shared_ptr<const ClothModel> pieces, std::shared_ptr<const std::vector<Seam>> seams);

  /// The same vertices and triangles with other pins, masses or materials. Throws ClothModelError, and changes nothing,
  /// if its seams could not be welded then.
  void change(std::shared_ptr<const ClothModel> pieces);

  /// The same vertices and triangles with other seams. A welded seam that is no longer there opens. Throws
  /// ClothModelError, and changes nothing, if its seams could not be welded then.
  void sew(std::shared_ptr<const ClothModel> pieces, std::shared_ptr<const std::vector<Seam>> seams, ClothState& state);

  [[nodiscard]] bool hasSeams() const { return !isWelded_.empty(); }
  /// The cloth without any weld.
  [[nodiscard]] const std::shared_ptr<const ClothModel>& pieces() const { return pieces_; }
  /// The cloth as it is now.
  [[nodiscard]] const std::shared_ptr<const ClothModel>& model() const { return model_; }
  /// All seams; null: none.
  [[nodiscard]] const std::shared_ptr<const std::vector<Seam>>& seams() const { return seams_; }
  /// Whether each of them is welded.
  [[nodiscard]] const std::vector<char>& isWelded() const { return isWelded_; }
  /// The seams that are not welded, between vertices with triangles.
  [[nodiscard]] std::span<const Seam> openSeams() const { return open_; }
  /// The vertices that are welded to that one, and itself.
  [[nodiscard]] std::vector<int> weldedTo(int vertex) const;

  /// The parameters of a step from that time [s]. The pieces of a garment have no weight until they are sewn together
  /// and can rest on a body. A seam that something keeps open delays this by no more than its duration.
  [[nodiscard]] StepParameters acting(StepParameters parameters, double time) const;

  /// Takes the model for a state that was replaced.
  void follow(const ClothState& state);

  /// After a step: welds the seams that are closed, and moves welded vertices with their leaders.
  /// @param weldDistance of pairs that are close enough [m], see weldDistanceOf  @return whether the model changed
  bool weld(double weldDistance, ClothState& state);

  /// Moves welded vertices with their leaders, after something else has moved those.
  void carry(ClothState& state) const;

  /// Gives welded vertices the values of their leaders.
  template <typename T>
  void spread(std::span<T> values) const {
    for (std::size_t v = 0; v < leaders_.size(); ++v) {
      values[v] = values[leaders_[v]];
    }
  }

 private:
  void update(std::vector<char> isWelded);
  /// Whether each seam is welded in a state.
  [[nodiscard]] std::vector<char> weldsOf(const ClothState& state) const;

  std::shared_ptr<const ClothModel> pieces_;
  std::shared_ptr<const std::vector<Seam>> seams_;
  std::shared_ptr<const ClothModel> model_;
  std::vector<char> isWelded_;  // of each seam
  std::vector<int> leaders_;    // of each vertex; empty: nothing is welded
  std::vector<Seam> open_;
};

/// The distance up to which the pairs of a seam are welded [m]. Contact of the cloth with itself keeps them apart by
/// its thickness.
[[nodiscard]] double weldDistanceOf(const ClothModel& model, const contact::ContactParameters& contact,
                                    const SolverInfo& solver);

}  // namespace drape::sim
