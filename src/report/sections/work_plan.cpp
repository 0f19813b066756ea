#include "report/sections/work_plan.hpp"

#include <cstddef>
#include <string_view>

namespace drape::report::sections {
namespace {

std::vector<ComparedCloth> ownCloths(const SetUp& setUp) {
  std::vector<ComparedCloth> cloths;
  for (const SpringCloth& cloth : setUp.cloths) {
    cloths.push_back({cloth.resolution, springsOf(cloth.stiffness), isMesh(setUp)});
  }
  return cloths;
}

std::vector<ComparedCloth> clothsOfQuickReport(const SetUp& setUp, bool isFirst) {
  if (!setUp.cloths.empty() && isFirst) {
    return ownCloths(setUp);
  }
  // A garment takes seconds a method, so a quick report has it only on request.
  if (isMesh(setUp) && isFirst) {
    return {{0, fabricOf("jersey"), true}};
  }
  if (setUp.name == "twist" && !isFirst) {
    return {{17, springsOf("10"), true}};
  }
  return isFirst ? std::vector<ComparedCloth>{{17, springsOf("10")},
                                              {17, springsOf("1e5"), true},
                                              {9, fabricOf("jersey")},
                                              {17, fabricOf("cotton"), true}}
                 : std::vector<ComparedCloth>{};
}

std::vector<ComparedCloth> clothsOfFullReport(const SetUp& setUp, bool isFirst) {
  if (!setUp.cloths.empty()) {
    return ownCloths(setUp);
  }
  if (isMesh(setUp)) {
    return {{0, fabricOf("cotton")}, {0, fabricOf("jersey")}};
  }
  std::vector<ComparedCloth> cloths;
  for (const int resolution : {17, 33, 65}) {
    for (const char* stiffness : {"10", "1000", "1e5"}) {
      // The largest cloths take most of the time: the first set-up has all of them, the others one each.
      if (isFirst || resolution < 65 || std::string_view(stiffness) == "1000") {
        cloths.push_back({resolution, springsOf(stiffness)});
      }
    }
    for (const char* preset : {"cotton", "jersey"}) {
      if (isFirst && resolution < 65) {
        cloths.push_back({resolution, fabricOf(preset)});
      }
    }
  }
  return cloths;
}

}  // namespace

std::vector<ComparedCloth> comparedCloths(const SetUp& setUp, bool isFirst, bool quick) {
  return quick ? clothsOfQuickReport(setUp, isFirst) : clothsOfFullReport(setUp, isFirst);
}

std::vector<std::string> valuesOn(const ComparedCloth& cloth, const MethodCurve& curve, bool quick) {
  constexpr std::size_t stride = 3;  // on a mesh, where every run takes long
  if (quick || cloth.resolution > 0) {
    return quick ? curve.quick : curve.values;
  }
  std::vector<std::string> values;
  for (std::size_t i = 0; i < curve.values.size(); i += stride) {
    values.push_back(curve.values[i]);
  }
  return values;
}

bool takes(const sim::SolverInfo& solver, const ComparedCloth& cloth) {
  const bool fabric = cloth.material.isFabric();
  // The implicit solvers have vector instructions for springs only.
  const bool fast = hasVectorLoops(solver) && !(fabric && solver.backwardEuler);
  return (!fabric || solver.takesFabric) && (!cloth.fastMethods || fast);
}

bool isMeasuredOn(const ComparedCloth& cloth, const MethodCurve& curve) {
  const sim::SolverInfo* solver = sim::findSolver(curve.method);
  return solver != nullptr && takes(*solver, cloth) && (!curve.fabricOnly || cloth.material.isFabric());
}

}  // namespace drape::report::sections
