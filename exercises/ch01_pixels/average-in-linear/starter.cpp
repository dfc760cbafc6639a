#include "api.hpp"

namespace exercise {

std::vector<int> halved_codes(const Picture& /*picture*/) {
  TODO("replace each block of 2 x 2 pixels by one code");
}

}  // namespace exercise
