#ifndef signorini_input_text_format_h
#define signorini_input_text_format_h

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /** Pieces of a document in a language of mark-up. */
  class TextFormat
  {
  public:
    virtual ~TextFormat() = default;

    /** What comes before and after all else; the language decides. */
    virtual std::string
    begin(const std::string &title) const = 0;
    virtual std::string
    end() const = 0;

    /** Plain text; what is written `so' becomes code. */
    std::string
    text(const std::string &plain) const;

    /** Names and values as they are typed; empty stays empty. */
    virtual std::string
    code(const std::string &plain) const = 0;

    /** @p content and all below is formatted already. */
    virtual std::string
    link(const std::string &content, const std::string &target) const = 0;

    /** Something that `#' + @p id leads to, if the language can do so. */
    virtual std::string
    target(const std::string &id, const std::string &content) const = 0;

    /** A heading of level 1, 2 or 3 that `#' + anchor(plain) leads to. */
    virtual std::string
    heading(const unsigned int level, const std::string &plain) const = 0;

    virtual std::string
    paragraph(const std::string &content) const = 0;

    virtual std::string
    image(const std::string &file, const std::string &plain) const = 0;

    virtual std::string
    list(const std::vector<std::string> &items) const = 0;

    /** The first row is the heading; of others the first cell is a name. */
    virtual std::string
    table(const std::vector<std::vector<std::string>> &rows) const = 0;

    /** As GitHub makes it of a heading: `#' and this lead to it. */
    static std::string
    anchor(const std::string &heading);

  protected:
    /** Without characters that the language takes for its own. */
    virtual std::string
    escaped(const std::string &plain) const = 0;
  };

  /** Markdown as GitHub reads it. */
  std::unique_ptr<TextFormat>
  markdown();

  /** A page of HTML that needs no other file but its pictures. */
  std::unique_ptr<TextFormat>
  html();
} // namespace Signorini

#endif
