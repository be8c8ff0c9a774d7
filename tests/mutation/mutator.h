#ifndef signorini_tests_mutation_mutator_h
#define signorini_tests_mutation_mutator_h

#include <random>
#include <string>
#include <vector>

/**
 * Spoils texts in the ways in which people and programs do: numbers that are
 * none or too large, lines that are lost or doubled, words of another place,
 * wrong punctuation, broken bytes, files cut short. The same seed gives the
 * same texts.
 */
class Mutator
{
public:
  /** @param pool texts from which lines and words are taken */
  Mutator(const unsigned int seed, const std::vector<std::string> &pool);

  /** The text with one to three changes. */
  std::string
  mutate(std::string text);

  /** One of n, each as likely. */
  std::size_t
  choose(const std::size_t n);

private:
  const std::string &
  any(const std::vector<std::string> &list);

  void
  change_number(std::string &text);

  void
  change_value(std::string &text);

  void
  change_lines(std::string &text);

  void
  change_word(std::string &text);

  void
  change_bytes(std::string &text);

  std::mt19937             generator;
  std::vector<std::string> pool_lines;
  std::vector<std::string> pool_words;
};

#endif
