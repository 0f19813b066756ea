#include "text/words.hpp"

#include <algorithm>
#include <cctype>

namespace drape::text {

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

}  // namespace drape::text
