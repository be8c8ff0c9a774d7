#include <signorini/input/text_format.h>

#include <cctype>

namespace Signorini
{
  namespace
  {
    using Row = std::vector<std::string>;

    std::string
    replaced(const std::string                               &text,
             const std::vector<std::pair<char, std::string>> &replacements)
    {
      std::string result;
      for (const char c : text)
        {
          std::string piece(1, c);
          for (const auto &[character, replacement] : replacements)
            if (c == character)
              piece = replacement;
          result += piece;
        }
      return result;
    }



    class Markdown : public TextFormat
    {
    public:
      std::string
      begin(const std::string &title) const override
      {
        return heading(1, title);
      }

      std::string
      end() const override
      {
        return "";
      }

      // In a table a bar has to be escaped even here.
      std::string
      code(const std::string &plain) const override
      {
        return plain.empty() ? "" : '`' + replaced(plain, {{'|', "\\|"}}) + '`';
      }

      std::string
      link(const std::string &content, const std::string &target) const override
      {
        return "[" + content + "](" + target + ")";
      }

      // Markdown can only lead to headings.
      std::string
      target(const std::string & /*id*/,
             const std::string &content) const override
      {
        return content;
      }

      std::string
      heading(const unsigned int level, const std::string &plain) const override
      {
        return (level == 1 ? "" : "\n") + std::string(level, '#') + " " +
               plain + "\n";
      }

      std::string
      paragraph(const std::string &content) const override
      {
        return "\n" + content + "\n";
      }

      std::string
      image(const std::string &file, const std::string &plain) const override
      {
        return "\n![" + plain + "](" + file + ")\n";
      }

      std::string
      list(const std::vector<std::string> &items) const override
      {
        std::string text = "\n";
        for (const std::string &item : items)
          text += "- " + item + "\n";
        return text;
      }

      std::string
      table(const std::vector<Row> &rows) const override
      {
        std::string text = "\n" + line(rows.front());
        text += line(Row(rows.front().size(), "---"));
        for (std::size_t i = 1; i < rows.size(); ++i)
          text += line(rows[i]);
        return text;
      }

    protected:
      std::string
      escaped(const std::string &plain) const override
      {
        return replaced(plain,
                        {{'|', "\\|"},
                         {'*', "\\*"},
                         {'_', "\\_"},
                         {'<', "&lt;"},
                         {'[', "\\["},
                         {']', "\\]"}});
      }

    private:
      static std::string
      line(const Row &row)
      {
        std::string text = "|";
        for (const std::string &cell : row)
          text += " " + cell + " |";
        return text + "\n";
      }
    };



    class Html : public TextFormat
    {
    public:
      std::string
      begin(const std::string &title) const override
      {
        return "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
               "<title>" +
               escaped(title) +
               "</title>\n<style>\nbody{font:15px/1.4 sans-serif;max-width:"
               "75em;margin:2em auto;padding:0 1em}\ntable{border-collapse:"
               "collapse}\nth,td{border:1px solid #ccc;padding:.3em .5em;"
               "text-align:left;vertical-align:top}\nth{background:#f2f2f2}\n"
               "td:first-child{white-space:nowrap}\ncode{background:#f5f5f5}\n"
               "a:target{background:#ffd}\n</style>\n" +
               heading(1, title);
      }

      std::string
      end() const override
      {
        return "</html>\n";
      }

      std::string
      code(const std::string &plain) const override
      {
        return plain.empty() ? "" : "<code>" + escaped(plain) + "</code>";
      }

      std::string
      link(const std::string &content, const std::string &target) const override
      {
        return "<a href=\"" + target + "\">" + content + "</a>";
      }

      std::string
      target(const std::string &id, const std::string &content) const override
      {
        return "<a id=\"" + id + "\" href=\"#" + id + "\">" + content + "</a>";
      }

      std::string
      heading(const unsigned int level, const std::string &plain) const override
      {
        const std::string tag = "h" + std::to_string(level);
        return "<" + tag + " id=\"" + anchor(plain) + "\">" + escaped(plain) +
               "</" + tag + ">\n";
      }

      std::string
      paragraph(const std::string &content) const override
      {
        return "<p>" + content + "</p>\n";
      }

      std::string
      image(const std::string &file, const std::string &plain) const override
      {
        return "<p><img src=\"" + file + "\" alt=\"" + escaped(plain) +
               "\"></p>\n";
      }

      std::string
      list(const std::vector<std::string> &items) const override
      {
        std::string text = "<ul>\n";
        for (const std::string &item : items)
          text += "<li>" + item + "</li>\n";
        return text + "</ul>\n";
      }

      std::string
      table(const std::vector<Row> &rows) const override
      {
        std::string text = "<table>\n" + line(rows.front(), "th");
        for (std::size_t i = 1; i < rows.size(); ++i)
          text += line(rows[i], "td");
        return text + "</table>\n";
      }

    protected:
      std::string
      escaped(const std::string &plain) const override
      {
        return replaced(
          plain,
          {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}});
      }

    private:
      static std::string
      line(const Row &row, const std::string &tag)
      {
        std::string text = "<tr>";
        for (const std::string &cell : row)
          text += "<" + tag + ">" + cell + "</" + tag + ">";
        return text + "</tr>\n";
      }
    };
  } // namespace



  std::string
  TextFormat::text(const std::string &plain) const
  {
    std::string result, rest = plain;
    for (auto open = rest.find('`'); open != std::string::npos;
         open      = rest.find('`'))
      {
             const auto close = rest.find('\'', open);
             if (close == std::string::npos)
          break;
        result += escaped(rest.substr(0, open)) +
                       code(rest.substr(open + 1, close - open - 1));
             rest = rest.substr(close + 1);
      }
    return result + escaped(rest);
  }



  std::string
  TextFormat::anchor(const std::string &heading)
  {
    std::string result;
    for (const unsigned char c : heading)
      if (c == ' ')
        result += '-';
      else if (std::isalnum(c) || c == '-' || c == '_')
        result += static_cast<char>(std::tolower(c));
    return result;
  }



  std::unique_ptr<TextFormat>
  markdown()
  {
    return std::make_unique<Markdown>();
  }



  std::unique_ptr<TextFormat>
  html()
  {
    return std::make_unique<Html>();
  }
} // namespace Signorini
