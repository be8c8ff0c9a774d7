#ifndef tests_unit_gear_lines_h
#define tests_unit_gear_lines_h

#include <sstream>

#include "gear_reference.h"
#include "mesh_measures.h"

namespace GearReference
{
  /** Where the teeth stand, and the bodies below them. */
  struct Place
  {
    unsigned int     n_modelled = 3;
    unsigned int     at_pitch   = 2;
    bool             right      = true;
    double           roll       = 0.; // radian
    dealii::Point<2> pitch_point;
    double           bore  = 0.6; // of the pitch radius
    double           back  = 2.;  // modules
    unsigned int     cells = 8;
  };

  inline std::string
  common_lines(const Gear &gear, const Place &place)
  {
    std::ostringstream lines;
    lines.precision(17);
    lines << " set Module = " << gear.tooth.module
          << "\n set Pressure angle = " << gear.tooth.pressure_angle
          << "\n set Addendum = " << gear.tooth.addendum
          << "\n set Dedendum = " << gear.tooth.dedendum
          << "\n set Profile shift = " << gear.tooth.profile_shift
          << "\n set Fillet radius = " << gear.tooth.fillet_radius
          << "\n set Tooth thinning = " << gear.tooth.thinning
          << "\n set Tip relief = " << gear.tooth.relief
          << "\n set Tip relief length = " << gear.tooth.relief_length
          << "\n set Modelled teeth = " << place.n_modelled
          << "\n set Tooth at pitch point = " << place.at_pitch
          << "\n set Working flanks = " << (place.right ? "right" : "left")
          << "\n set Roll angle = " << place.roll * 180. / pi
          << "\n set Pitch point = " << place.pitch_point[0] << ", "
          << place.pitch_point[1]
          << "\n set Cells along a flank = " << place.cells << "\n";
    return lines.str();
  }

  inline std::string
  pinion_lines(const Gear &gear, const Place &place)
  {
    std::ostringstream lines;
    lines.precision(17);
    lines << "set Mesh = pinion\nsubsection Pinion\n set Teeth = "
          << gear.n_teeth
          << "\n set Bore radius = " << place.bore * gear.pitch_radius() << "\n"
          << common_lines(gear, place) << "end\n";
    return lines.str();
  }

  inline std::string
  rack_lines(const Gear &gear, const Place &place)
  {
    std::ostringstream lines;
    lines.precision(17);
    lines << "set Mesh = rack\nsubsection Rack\n set Teeth of the pinion = "
          << gear.n_teeth
          << "\n set Back thickness = " << place.back * gear.tooth.module
          << "\n"
          << common_lines(gear, place) << "end\n";
    return lines.str();
  }

  /** The vertices of a boundary, those inside it twice. */
  inline std::vector<dealii::Point<2>>
  vertices_on(const Signorini::Mesh<2> &mesh, const std::string &name)
  {
    std::vector<dealii::Point<2>> points;
    const auto                    id = mesh.boundary(name);
    for (const auto &face : mesh.triangulation->active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == id)
        for (const unsigned int v : face->vertex_indices())
          points.push_back(face->vertex(v));
    BOOST_TEST(points.size() > 0u);
    return points;
  }
} // namespace GearReference

#endif
