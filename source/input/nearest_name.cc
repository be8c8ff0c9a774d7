#include <signorini/input/nearest_name.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace Signorini
{
  namespace
  {
    bool
    same_letter(const char a, const char b)
    {
      return std::tolower(static_cast<unsigned char>(a)) ==
             std::tolower(static_cast<unsigned char>(b));
    }

    // Levenshtein's distance, row by row.
    std::size_t
    edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 0; i < a.size(); ++i)
        {
          std::size_t diagonal = row[0];
          row[0]               = i + 1;
          for (std::size_t j = 0; j < b.size(); ++j)
            {
              const std::size_t replace =
                diagonal + (same_letter(a[i], b[j]) ? 0 : 1);
              diagonal   = row[j + 1];
              row[j + 1] = std::min({replace, row[j] + 1, row[j + 1] + 1});
            }
        }
      return row.back();
    }
  } // namespace



  std::string
  nearest_name(const std::string              &name,
               const std::vector<std::string> &candidates)
  {
    std::string nearest;
    std::size_t smallest = std::max<std::size_t>(2, name.size() / 3) + 1;
    smallest             = std::min(smallest, name.size());
    for (const std::string &candidate : candidates)
      {
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < smallest)
          {
            smallest = distance;
            nearest  = candidate;
          }
      }
    return nearest;
  }



  std::string
  did_you_mean(const std::string              &name,
               const std::vector<std::string> &candidates)
  {
    const std::string nearest = nearest_name(name, candidates);
    return nearest.empty() ? "" : " Did you mean \"" + nearest + "\"?";
  }



  std::string
  comma_separated(const std::vector<std::string> &names)
  {
    std::string list;
    for (const std::string &name : names)
      list += (list.empty() ? "" : ", ") + name;
    return list.empty() ? "none" : list;
  }
} // namespace Signorini
