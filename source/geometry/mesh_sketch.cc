#include <signorini/geometry/mesh_sketch.h>

#include <array>
#include <sstream>
#include <vector>

#include "outward_normal.h"
#include "sketch_canvas.h"
#include "svg.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // In tenths of a pixel; the margin is for names.
    constexpr double drawn_width = 4200., margin = 1050.,
                     distance_of_name = 100., font_size = 120.;

    // Colours that can also be told apart by who sees few of them.
    constexpr std::array<const char *, 8> colours = {{"#0072b2",
                                                      "#d55e00",
                                                      "#009e73",
                                                      "#cc79a7",
                                                      "#b8860b",
                                                      "#56b4e9",
                                                      "#7b3294",
                                                      "#666666"}};

    // A face of the boundary in the picture.
    struct SketchFace
    {
      types::boundary_id    id;
      std::vector<Point<2>> corners;
      Point<2>              centre;
      Tensor<1, 2>          normal; // out of the body, of unit length or zero
      double                depth;  // grows towards who looks
      bool                  is_visible;
    };

    // Vertices of a face in their order around it.
    template <typename Face>
    std::vector<unsigned int>
    around(const Face &face)
    {
      return face->n_vertices() == 2 ? std::vector<unsigned int>{0, 1} :
                                       std::vector<unsigned int>{0, 1, 3, 2};
    }

    template <int dim>
    SketchFace
    drawn_face(const typename Triangulation<dim>::active_cell_iterator &cell,
               const unsigned int                                       f,
               const SketchCanvas<dim>                                 &canvas)
    {
      const SketchView<dim> view;
      const auto            face = cell->face(f);
      const Tensor<1, dim>  normal =
        outward_normal<dim>(cell->face(f), cell->center());
      Tensor<1, 2> flat = projected<dim>(normal);
      flat /= std::max(flat.norm(), 1e-6);
      SketchFace drawn = {face->boundary_id(),
                          {},
                          canvas(face->center()),
                          flat,
                          canvas.scale * (face->center() * view.towards),
                          dim == 2 || normal * view.towards > 1e-6};
      for (const unsigned int v : around(face))
        drawn.corners.push_back(canvas(face->vertex(v)));
      return drawn;
    }

    // The nearer ones are drawn later, and hide the others.
    template <int dim>
    std::vector<SketchFace>
    boundary_faces(const Mesh<dim> &mesh, const SketchCanvas<dim> &canvas)
    {
      std::vector<SketchFace> faces;
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            faces.push_back(drawn_face<dim>(cell, f, canvas));
      std::stable_sort(faces.begin(),
                       faces.end(),
                       [](const SketchFace &a, const SketchFace &b) {
                         return std::lround(a.depth + 0.001) <
                                std::lround(b.depth + 0.001);
                       });
      return faces;
    }



    // Cells behind those of 3-D cannot be seen.
    template <int dim>
    std::string
    drawn_cells(const Mesh<dim> &mesh, const SketchCanvas<dim> &canvas)
    {
      if constexpr (dim == 2)
        {
          std::string text = "<path class=\"cells\" d=\"";
          for (const auto &cell : mesh.triangulation->active_cell_iterators())
            text += svg_path({canvas(cell->vertex(0)),
                              canvas(cell->vertex(1)),
                              canvas(cell->vertex(3)),
                              canvas(cell->vertex(2))}) +
                    "z";
          return text + "\"/>\n";
        }
      return "";
    }

    // All faces of one boundary that follow each other in the list.
    std::string
    drawn_faces(const std::vector<SketchFace>                   &faces,
                const std::map<types::boundary_id, std::string> &colours_of)
    {
      std::string text, colour;
      for (const SketchFace &face : faces)
        if (face.is_visible)
          {
            const auto        found = colours_of.find(face.id);
            const std::string wanted =
              found == colours_of.end() ? "#000" : found->second;
            if (wanted != colour)
              text += (text.empty() ? "" : "\"/>\n") + std::string("<path ") +
                      (face.corners.size() == 2 ? "stroke" : "fill") + "=\"" +
                      wanted + "\" d=\"";
            colour = wanted;
            text +=
              svg_path(face.corners) + (face.corners.size() == 2 ? "" : "z");
          }
      return text + "\"/>\n";
    }



    /** Finds places for names, one after the other. */
    class NamePlaces
    {
    public:
      /** The first of them that leaves the others free, or else the first. */
      SvgWords
      best(const std::vector<SvgWords> &candidates)
      {
        const auto free =
          std::find_if(candidates.begin(),
                       candidates.end(),
                       [&](const SvgWords &words) { return is_free(words); });
        const SvgWords &chosen =
          free == candidates.end() ? candidates.front() : *free;
        boxes.push_back(svg_box(chosen, font_size));
        return chosen;
      }

    private:
      bool
      is_free(const SvgWords &words) const
      {
        const auto [low, high] = svg_box(words, font_size);
        for (const auto &box : boxes)
          if (low[0] < box.second[0] && box.first[0] < high[0] &&
              low[1] < box.second[1] && box.first[1] < high[1])
            return false;
        return true;
      }

      std::vector<std::pair<Point<2>, Point<2>>> boxes;
    };

    // Faces that can be seen, if there are some, and those nearest to the
    // middle of all first.
    std::vector<const SketchFace *>
    faces_to_name(const std::vector<SketchFace> &faces,
                  const types::boundary_id       id)
    {
      std::vector<const SketchFace *> list;
      for (const bool is_visible : {true, false})
        if (list.empty())
          for (const SketchFace &face : faces)
            if (face.id == id && face.is_visible == is_visible)
              list.push_back(&face);
      Tensor<1, 2> middle;
      for (const SketchFace *face : list)
        middle += face->centre / double(list.size());
      const auto distance = [&](const SketchFace *face) {
        return std::lround((face->centre - middle).norm() + 0.001);
      };
      std::stable_sort(list.begin(),
                       list.end(),
                       [&](const SketchFace *a, const SketchFace *b) {
                         return distance(a) < distance(b);
                       });
      return list;
    }

    // Outside of the body, inside of it, or on a surface.
    template <int dim>
    std::vector<SvgWords>
    places_of_name(const std::string             &name,
                   const std::vector<SketchFace> &faces,
                   const types::boundary_id       id,
                   const SketchCanvas<dim>       &canvas,
                   const std::string             &colour)
    {
      std::vector<SvgWords> list;
      for (const SketchFace *face : faces_to_name(faces, id))
        if (!face->is_visible)
          list.push_back(
            {name + " (behind)",
             canvas.edge(face->normal) + distance_of_name * face->normal,
             face->normal,
             colour});
        else if (dim == 3)
          list.push_back({name, face->centre, {}, "#000"});
        else
          for (const double side : {1., -1.})
            list.push_back(
              {name,
               face->centre + side * distance_of_name * face->normal,
               side * face->normal,
               colour});
      return list;
    }



    template <int dim>
    std::string
    drawn_axes(const double height)
    {
      const std::array<const char *, 3> names = {{"x", "y", "z"}};
      const Point<2>                    origin(320., height - 240.);
      std::string                       text;
      for (unsigned int c = 0; c < dim; ++c)
        {
          Tensor<1, dim> axis;
          axis[c]                      = 1.;
          const Tensor<1, 2> direction = projected<dim>(axis);
          text += "<path class=\"axis\" d=\"" +
                  svg_path({origin, origin + 240. * direction}) + "\"/>\n" +
                  svg_text({names[c], origin + 330. * direction, {}, "#444"},
                           font_size);
        }
      return text;
    }

    std::string
    style(const unsigned int dim)
    {
      return std::string(
               "<style>text{font:120px sans-serif;paint-order:stroke;stroke:"
               "#fff;stroke-width:30}path{stroke-linecap:round;") +
             (dim == 2 ?
                "fill:none;stroke-width:25}.cells{fill:#f2f2f2;stroke:#ccc;"
                "stroke-width:6}" :
                "stroke:#fff;stroke-width:6}") +
             ".axis{stroke:#444;stroke-width:12}</style>\n";
    }

    std::string
    opening(const double width, const double height)
    {
      std::ostringstream text;
      text << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\""
           << std::lround(width / 10.) << "\" height=\""
           << std::lround(height / 10.) << "\" viewBox=\"0 0 "
           << std::lround(width) << ' ' << std::lround(height) << "\">\n";
      return text.str();
    }
  } // namespace



  template <int dim>
  std::string
  mesh_sketch(const Mesh<dim> &mesh)
  {
    const SketchCanvas<dim> canvas(*mesh.triangulation, drawn_width, margin);
    const std::vector<SketchFace> faces = boundary_faces(mesh, canvas);
    NamePlaces                    places;
    std::string                   names;
    std::map<types::boundary_id, std::string> colour_of;
    for (const auto &[name, id] : mesh.boundaries)
      {
        const std::string colour = colours[colour_of.size() % colours.size()];
        colour_of[id]            = colour;
        names +=
          svg_text(places.best(places_of_name(name, faces, id, canvas, colour)),
                   font_size);
      }
    const double width  = canvas.size[0] + 2. * margin;
    const double height = canvas.size[1] + 2. * margin;
    return opening(width, height) + style(dim) + drawn_cells(mesh, canvas) +
           drawn_faces(faces, colour_of) + names + drawn_axes<dim>(height) +
           "</svg>\n";
  }

  template std::string
  mesh_sketch<2>(const Mesh<2> &);
  template std::string
  mesh_sketch<3>(const Mesh<3> &);
} // namespace Signorini
