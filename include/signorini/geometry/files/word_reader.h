#ifndef signorini_geometry_files_word_reader_h
#define signorini_geometry_files_word_reader_h

#include <string>

namespace Signorini
{
  /**
   * Reads a text file word by word (words end at white space), or line by
   * line, and knows the line it is in. All errors are InputErrors that begin
   * with the name of the file and this line.
   */
  class WordReader
  {
  public:
    WordReader(std::string file_name, std::string text);

    /** Is there another word? */
    bool
    has_word();

    /** The next word. @p what is the text of the error if there is none. */
    std::string
    word(const std::string &what);

    double
    number(const std::string &what);

    long
    integer(const std::string &what);

    /** An integer that is not negative. */
    unsigned int
    count(const std::string &what);

    /** The text between two quotation marks. */
    std::string
    quoted(const std::string &what);

    /** The rest of the line, without white space at its ends. */
    std::string
    line();

    /** Converts a word that was read before. */
    double
    to_number(const std::string &word, const std::string &what) const;

    long
    to_integer(const std::string &word, const std::string &what) const;

    [[noreturn]] void
    fail(const std::string &message) const;

    const std::string file_name;

  private:
    void
    skip_white_space();

    std::string text;
    std::size_t position    = 0;
    std::size_t line_number = 1;
  };
} // namespace Signorini

#endif
