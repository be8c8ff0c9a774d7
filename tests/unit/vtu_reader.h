#ifndef tests_unit_vtu_reader_h
#define tests_unit_vtu_reader_h

#include <deal.II/base/utilities.h>

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

/**
 * Just enough of VTK's XML format to read back what the program writes:
 * arrays of one zlib block in base64.
 */
class VtuReader
{
public:
  explicit VtuReader(const std::string &text)
    : text(text)
  {}

  /** An integer attribute of <Piece>: NumberOfPoints or NumberOfCells. */
  unsigned int
  number(const std::string &attribute) const
  {
    const std::size_t begin = find(attribute + "=\"", 0) + attribute.size() + 2;
    return std::stoul(text.substr(begin));
  }

  bool
  has_array(const std::string &name) const
  {
    return text.find("Name=\"" + name + "\"") != std::string::npos;
  }

  unsigned int
  n_components(const std::string &name) const
  {
    const std::string header = array_header(position_of(name));
    const std::size_t begin  = header.find("NumberOfComponents=\"");
    return begin == std::string::npos ? 1 :
                                        std::stoul(header.substr(begin + 20));
  }

  /** All numbers of a named array; of the coordinates for "Points". */
  std::vector<double>
  array(const std::string &name) const
  {
    const std::size_t begin  = position_of(name);
    const std::string header = array_header(begin);
    const std::size_t data   = text.find('>', begin) + 1;
    std::string       base64;
    for (const char c : text.substr(data, find("<", data) - data))
      if (c != ' ' && c != '\n')
        base64 += c;

    if (header.find("format=\"ascii\"") != std::string::npos)
      return {std::stod(text.substr(data))};
    const std::vector<unsigned char> bytes = decode(base64);
    if (header.find("Float32") != std::string::npos)
      return convert<float>(bytes);
    if (header.find("Float64") != std::string::npos)
      return convert<double>(bytes);
    if (header.find("UInt8") != std::string::npos)
      return convert<std::uint8_t>(bytes);
    return convert<std::int32_t>(bytes);
  }

private:
  std::size_t
  find(const std::string &what, const std::size_t begin) const
  {
    const std::size_t position = text.find(what, begin);
    if (position == std::string::npos)
      throw std::runtime_error("There is no " + what + " in the file.");
    return position;
  }

  std::size_t
  position_of(const std::string &name) const
  {
    if (name == "Points")
      return find("<DataArray", find("<Points>", 0));
    return text.rfind("<DataArray", find("Name=\"" + name + "\"", 0));
  }

  std::string
  array_header(const std::size_t begin) const
  {
    return text.substr(begin, text.find('>', begin) - begin);
  }

  static std::vector<unsigned char>
  decode(const std::string &base64)
  {
    // Four 32-bit numbers: blocks, size, size of the last, size compressed.
    const auto    head = dealii::Utilities::decode_base64(base64.substr(0, 24));
    std::uint32_t sizes[4];
    std::memcpy(sizes, head.data(), sizeof(sizes));
    const auto packed = dealii::Utilities::decode_base64(base64.substr(24));
    std::vector<unsigned char> bytes(sizes[1]);
    uLongf                     n_bytes = bytes.size();
    if (sizes[0] != 1 ||
        uncompress(bytes.data(), &n_bytes, packed.data(), sizes[3]) != Z_OK)
      throw std::runtime_error("An array cannot be unpacked.");
    return bytes;
  }

  template <typename Number>
  static std::vector<double>
  convert(const std::vector<unsigned char> &bytes)
  {
    std::vector<Number> numbers(bytes.size() / sizeof(Number));
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
    return std::vector<double>(numbers.begin(), numbers.end());
  }

  const std::string text;
};

#endif
