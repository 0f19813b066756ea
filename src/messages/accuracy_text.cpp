#include "messages/accuracy_text.hpp"

#include "messages/length_text.hpp"

namespace drape::messages {

text::Sentence inWords(const sim::Accuracy& accuracy) {
  const std::string seconds = brief(accuracy.seconds);
  return sim::isErrorKnown(accuracy)
             ? text::Sentence("{} after {} s", lengthInWords(accuracy.error), seconds)
             : text::Sentence("cannot be known: motions that start {} \u00B5m apart are {} apart after {} s",
                              brief(sim::testDisplacement * 1e6), lengthInWords(accuracy.spread), seconds);
}

}  // namespace drape::messages
