#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/regular_file.h>
#include <signorini/solid/displacement_files.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    const std::string index_head = "time [s],body,mesh,displacement\n";

    [[noreturn]] void
    refuse(const std::string &file_name, const std::string &what)
    {
      throw InputError("The file '" + file_name + "' " + what +
                       " Repeat the global run.");
    }

    std::string
    content_of(const std::string &file_name)
    {
      require_regular_file(file_name, largest_data);
      std::ifstream file(file_name, std::ios::binary);
      if (!file)
        refuse(file_name, "cannot be read.");
      std::ostringstream text;
      text << file.rdbuf(); // an empty file leaves nothing
      return text.str();
    }

    template <typename Number>
    void
    append(const Number number, std::string &content)
    {
      char bytes[sizeof(Number)];
      std::memcpy(bytes, &number, sizeof(Number));
      content.append(bytes, sizeof(Number));
    }

    // Takes the words and numbers of a file out of its content.
    class Content
    {
    public:
      explicit Content(const std::string &file_name)
        : file_name_(file_name)
        , content_(content_of(file_name))
        , position_(std::min(content_.find('\n'), content_.size() - 1) + 1)
        , head_(content_.substr(0, position_))
      {}

      void
      expect(const std::string &kind)
      {
        std::string word, version;
        if (!(head_ >> word >> version) || word + " " + version != kind ||
            !(head_ >> version) || version != "1")
          refuse(file_name_,
                 "is no file of this kind: it should begin with \"" + kind +
                   " 1\".");
      }

      unsigned int
      count(const std::string &name)
      {
        std::string word;
        long        value = -1;
        if (!(head_ >> word >> value) || word != name || value < 0 ||
            value > 4000000000)
          refuse_as_damaged();
        return value;
      }

      void
      expect_dimension(const unsigned int dim)
      {
        const unsigned int found = count("dimension");
        if (found != dim)
          throw InputError("The file '" + file_name_ +
                           "' comes from a run of "
                           "dimension " +
                           std::to_string(found) +
                           ", but this one has dimension " +
                           std::to_string(dim) +
                           ". Give the folder of a run of the same kind.");
      }

      void
      expect_bytes(const double n_bytes)
      {
        if (static_cast<double>(content_.size() - position_) != n_bytes)
          refuse_as_damaged();
      }

      template <typename Number>
      Number
      next()
      {
        Number number;
        std::memcpy(&number, content_.data() + position_, sizeof(Number));
        position_ += sizeof(Number);
        return number;
      }

      [[noreturn]] void
      refuse_as_damaged() const
      {
        refuse(file_name_, "is damaged, or not complete.");
      }

    private:
      const std::string  file_name_;
      const std::string  content_;
      std::size_t        position_;
      std::istringstream head_;
    };
  } // namespace



  std::string
  encode_index(const std::vector<StoredDisplacement> &rows)
  {
    std::string text = index_head;
    for (const StoredDisplacement &row : rows)
      {
        char       time[32];
        const auto end = std::to_chars(time, time + sizeof(time), row.time).ptr;
        text += std::string(time, end) + "," + row.body + "," + row.mesh_file +
                "," + row.displacement_file + "\n";
      }
    return text;
  }



  std::vector<StoredDisplacement>
  read_index(const std::string &folder)
  {
    const std::string file_name =
      (std::filesystem::path(folder) / displacement_index).string();
    std::error_code ignored;
    if (!std::filesystem::exists(file_name, ignored))
      throw InputError("The folder '" + folder + "' has no file '" +
                       displacement_index +
                       "', the list of the displacements that a global run "
                       "keeps for its submodels. Give the output folder of "
                       "such a run.");
    std::istringstream text(content_of(file_name));
    std::string        line;
    std::getline(text, line);
    if (line + "\n" != index_head)
      refuse(file_name,
             "is no list of displacements: it should begin with \"" +
               index_head.substr(0, index_head.size() - 1) + "\".");

    std::vector<StoredDisplacement> rows;
    while (std::getline(text, line))
      {
        StoredDisplacement row;
        std::istringstream words(line);
        std::string        time;
        std::getline(words, time, ',');
        std::getline(words, row.body, ',');
        std::getline(words, row.mesh_file, ',');
        std::getline(words, row.displacement_file, ',');
        const char *const end    = time.data() + time.size();
        const auto        result = std::from_chars(time.data(), end, row.time);
        if (result.ec != std::errc() || result.ptr != end ||
            !std::isfinite(row.time) || row.displacement_file.empty())
          refuse(file_name,
                 "is damaged: cannot understand the line \"" + line + "\".");
        rows.push_back(row);
      }
    return rows;
  }



  template <int dim>
  std::string
  encode_mesh(const NodalMesh<dim> &mesh)
  {
    std::string content = "signorini mesh 1 dimension " + std::to_string(dim) +
                          " degree " + std::to_string(mesh.degree) + " nodes " +
                          std::to_string(mesh.nodes.size()) + " cells " +
                          std::to_string(mesh.n_cells()) + "\n";
    for (const Point<dim> &node : mesh.nodes)
      for (unsigned int d = 0; d < dim; ++d)
        append(node[d], content);
    for (const std::uint32_t node : mesh.cells)
      append(node, content);
    return content;
  }



  template <int dim>
  std::string
  encode_displacements(const std::vector<Tensor<1, dim>> &displacements)
  {
    std::string content = "signorini displacement 1 dimension " +
                          std::to_string(dim) + " nodes " +
                          std::to_string(displacements.size()) + "\n";
    for (const Tensor<1, dim> &displacement : displacements)
      for (unsigned int d = 0; d < dim; ++d)
        append(displacement[d], content);
    return content;
  }



  template <int dim>
  NodalMesh<dim>
  read_mesh(const std::string &file_name)
  {
    Content content(file_name);
    content.expect("signorini mesh");
    content.expect_dimension(dim);
    NodalMesh<dim> mesh;
    mesh.degree                = content.count("degree");
    const unsigned int n_nodes = content.count("nodes");
    const unsigned int n_cells = content.count("cells");
    if (mesh.degree < 1 || mesh.degree > 20)
      content.refuse_as_damaged();
    const unsigned int n_a = mesh.n_nodes_per_cell();
    content.expect_bytes(8. * dim * n_nodes + 4. * n_a * n_cells);

    mesh.nodes.resize(n_nodes);
    for (Point<dim> &node : mesh.nodes)
      for (unsigned int d = 0; d < dim; ++d)
        node[d] = content.next<double>();
    mesh.cells.resize(std::size_t(n_a) * n_cells);
    for (unsigned int &node : mesh.cells)
      {
        node = content.next<std::uint32_t>();
        if (node >= n_nodes)
          content.refuse_as_damaged();
      }
    return mesh;
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  read_displacements(const std::string &file_name, const unsigned int n_nodes)
  {
    Content content(file_name);
    content.expect("signorini displacement");
    content.expect_dimension(dim);
    if (content.count("nodes") != n_nodes)
      refuse(file_name, "does not fit to the mesh it belongs to.");
    content.expect_bytes(8. * dim * n_nodes);
    std::vector<Tensor<1, dim>> displacements(n_nodes);
    for (Tensor<1, dim> &displacement : displacements)
      for (unsigned int d = 0; d < dim; ++d)
        displacement[d] = content.next<double>();
    return displacements;
  }

#define INSTANTIATE(dim)                                                    \
  template std::string encode_mesh<dim>(const NodalMesh<dim> &);            \
  template std::string encode_displacements<dim>(                           \
    const std::vector<Tensor<1, dim>> &);                                   \
  template NodalMesh<dim>              read_mesh<dim>(const std::string &); \
  template std::vector<Tensor<1, dim>> read_displacements<dim>(             \
    const std::string &, const unsigned int);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
