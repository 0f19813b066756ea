#include "bench/suite.hpp"

namespace drape::bench {

void addBulletGroup(Suite&) {}

}  // namespace drape::bench
