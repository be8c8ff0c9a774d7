#include <signorini/contact/overlap.h>
#include <signorini/input/instantiate.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    // A boundary in its present place.
    template <int dim>
    class PlacedSurface
    {
    public:
      PlacedSurface(const ContactorSurface<dim> &surface,
                    const DofVector             &displacement)
        : positions(node_positions(surface.nodes, displacement))
        , pieces(pieces_of(surface, positions))
        , curvatures(curvatures_of(surface, positions))
      {}

      const std::vector<Point<dim>> positions; // of the nodes, m
      const SurfacePieces<dim>      pieces;
      const std::vector<double>     curvatures; // of the pieces, 1/m

    private:
      static SurfacePieces<dim>
      pieces_of(const ContactorSurface<dim>   &surface,
                const std::vector<Point<dim>> &positions)
      {
        std::vector<std::vector<Point<dim>>> list;
        for (const auto &face : surface.faces)
          {
            list.emplace_back();
            for (const unsigned int node : face)
              list.back().push_back(positions[node]);
          }
        return SurfacePieces<dim>(std::move(list));
      }

      // By how much the normals at two nodes differ, over their distance; a
      // piece at the end of the surface bends like its neighbours.
      static std::vector<double>
      curvatures_of(const ContactorSurface<dim>   &surface,
                    const std::vector<Point<dim>> &positions)
      {
        const auto          normals = node_normals(surface, positions);
        std::vector<double> at_nodes(positions.size());
        for (const auto &face : surface.faces)
          {
            double largest = 0.;
            for (const unsigned int a : face)
              for (const unsigned int b : face)
                if (a < b && positions[a] != positions[b])
                  largest = std::max(largest,
                                     (normals[a] - normals[b]).norm() /
                                       positions[a].distance(positions[b]));
            for (const unsigned int a : face)
              at_nodes[a] = std::max(at_nodes[a], largest);
          }
        std::vector<double> result;
        for (const auto &face : surface.faces)
          {
            result.push_back(0.);
            for (const unsigned int a : face)
              result.back() = std::max(result.back(), at_nodes[a]);
          }
        return result;
      }
    };



    // Evenly spaced points of a piece, with its corners, so many along an edge.
    template <int dim>
    std::vector<Point<dim>>
    points_of(const std::vector<Point<dim>> &piece, const double spacing)
    {
      constexpr unsigned int least = dim == 2 ? 8 : 4,
                             most  = dim == 2 ? 64 : 16;
      const auto n_along = [&](const unsigned int a, const unsigned int b) {
        const double n = std::ceil(piece[a].distance(piece[b]) / spacing);
        return static_cast<unsigned int>(std::clamp<double>(n, least, most));
      };
      const unsigned int      n_first  = n_along(0, 1);
      const unsigned int      n_second = dim == 3 ? n_along(0, 2) : 0;
      std::vector<Point<dim>> points;
      for (unsigned int j = 0; j <= n_second; ++j)
        for (unsigned int i = 0; i <= n_first; ++i)
          {
            const double xi    = double(i) / n_first;
            Point<dim>   point = piece[0] + xi * (piece[1] - piece[0]);
            if (dim == 3)
              point += double(j) / n_second *
                       (piece[2] + xi * (piece[3] - piece[2]) - point);
            points.push_back(point);
          }
      return points;
    }



    // Lengths h and curvatures 1/R where two surfaces meet.
    struct Meeting
    {
      double length        = 0.; // of the contactor, m
      double target_length = 0.; // m
      double curvature     = 0.; // of the two together, 1/m
    };

    template <int dim>
    class OverlapSearch
    {
    public:
      explicit OverlapSearch(const OverlapQuery<dim> &query)
        : query_(query)
        , contactor_(query.pair.surface, query.configuration.displacement)
      {
        for (unsigned int n = 0; n < query.pair.contactor.nodes.size(); ++n)
          if (!query.normal_forces.empty() &&
              query.normal_forces[query.pair.first_contact + n] > 0.)
            pressed_.push_back(
              contactor_.positions[query.pair.node_of_candidate[n]]);
      }

      std::vector<Overlap<dim>>
      find()
      {
        if (query_.target_body)
          search_deformable();
        else
          search_rigid();
        return std::move(found_);
      }

    private:
      void
      search_deformable();

      void
      search_rigid();

      // Points of the pieces of one surface inside of a body.
      void
      search_pieces(const PlacedSurface<dim>  &surface,
                    const OccupiedRegion<dim> &body,
                    const double               spacing,
                    const PlacedSurface<dim>  &target);

      // Points of a rigid surface inside of the contactor's body.
      void
      search_body(const PlacedTarget<dim> &target);

      void
      add(const Point<dim> &place, const double depth, const Meeting &meeting);

      // Is there no target at a great distance, in any direction?
      bool
      ends(const PlacedTarget<dim> &target) const;

      // Of the target at a point on it, 1/m.
      double
      curvature_at(const PlacedTarget<dim> &target,
                   const Point<dim>        &point) const;

      TargetPoint<dim>
      closest(const PlacedTarget<dim> &target, const Point<dim> &point) const
      {
        return *target.closest(
          {point, {}, {}, numbers::invalid_unsigned_int, true});
      }

      const OverlapQuery<dim>   query_;
      const PlacedSurface<dim>  contactor_;
      std::vector<Point<dim>>   pressed_; // contactor nodes with a force
      std::vector<Overlap<dim>> found_;
    };



    template <int dim>
    void
    OverlapSearch<dim>::add(const Point<dim> &place,
                            const double      depth,
                            const Meeting    &meeting)
    {
      // A surface that turns within a 50th of an element is an edge: it has
      // no sagitta.
      const bool   is_edge = meeting.curvature * meeting.length > 50.;
      const double radius =
        meeting.curvature > 0. && !is_edge ? 1. / meeting.curvature : infinity;
      const double squares = meeting.length * meeting.length +
                             meeting.target_length * meeting.target_length;
      const double sagitta =
        std::min(squares / radius, std::min(meeting.length, radius)) / 8.;
      if (!(depth > sagitta))
        return;
      const bool is_pressed =
        std::any_of(pressed_.begin(), pressed_.end(), [&](const auto &node) {
          return node.distance(place) < 2. * meeting.length + depth;
        });
      found_.push_back({place,
                        depth,
                        sagitta,
                        meeting.length,
                        query_.target_body ? infinity : radius,
                        is_pressed});
    }



    template <int dim>
    void
    OverlapSearch<dim>::search_deformable()
    {
      const PlacedSurface<dim> target(*query_.target_surface,
                                      query_.configuration.displacement);
      const auto shortest = [](const PlacedSurface<dim> &surface) {
        double result = infinity;
        for (unsigned int i = 0; i < surface.pieces.size(); ++i)
          {
            const auto &piece = surface.pieces[i];
            for (unsigned int a = 1; a < piece.size(); ++a)
              result = std::min(result, piece[0].distance(piece[a]));
          }
        return result;
      };
      search_pieces(contactor_,
                    *query_.target_body,
                    0.5 * shortest(target),
                    target);
      search_pieces(target, query_.body, 0.5 * shortest(contactor_), target);
    }



    template <int dim>
    void
    OverlapSearch<dim>::search_pieces(const PlacedSurface<dim>  &surface,
                                      const OccupiedRegion<dim> &body,
                                      const double               spacing,
                                      const PlacedSurface<dim>  &target)
    {
      for (unsigned int i = 0; i < surface.pieces.size(); ++i)
        {
          if (!body.is_near(surface.pieces[i]))
            continue;
          for (const Point<dim> &point :
               points_of<dim>(surface.pieces[i], spacing))
            if (const auto depth = body.depth(point))
              {
                const unsigned int c = contactor_.pieces.nearest(point).first;
                const unsigned int t = target.pieces.nearest(point).first;
                add(point,
                    *depth,
                    {contactor_.pieces.length(c),
                     target.pieces.length(t),
                     contactor_.curvatures[c] + target.curvatures[t]});
              }
        }
    }



    template <int dim>
    void
    OverlapSearch<dim>::search_rigid()
    {
      const auto target =
        query_.pair.target->place(query_.configuration, query_.configuration);
      for (unsigned int i = 0; i < contactor_.pieces.size(); ++i)
        {
          const double length = contactor_.pieces.length(i);
          if (closest(*target, contactor_.pieces[i][0]).gap > 2. * length)
            continue;
          for (const Point<dim> &point :
               points_of<dim>(contactor_.pieces[i], length))
            {
              const auto found = closest(*target, point);
              if (found.gap >= 0.)
                continue;
              const Point<dim> on_target = point - found.gap * found.normal;
              add(point,
                  -found.gap,
                  {length,
                   0.,
                   contactor_.curvatures[i] +
                     curvature_at(*target, on_target)});
            }
        }
      search_body(*target);
    }



    template <int dim>
    void
    OverlapSearch<dim>::search_body(const PlacedTarget<dim> &target)
    {
      const bool has_an_end = ends(target);
      for (const Point<dim> &centre : query_.body.cell_centres())
        {
          const auto found = closest(target, centre);
          if (std::abs(found.gap) > query_.body.largest_cell())
            continue;
          const Point<dim> point = centre - found.gap * found.normal;
          const auto       depth = query_.body.depth(point);
          if (!depth)
            continue;
          // A surface without end may pass through the body elsewhere.
          const auto [c, distance] = contactor_.pieces.nearest(point);
          if (!has_an_end && distance > *depth * (1. + 1e-6))
            continue;
          add(point,
              *depth,
              {contactor_.pieces.length(c),
               0.,
               contactor_.curvatures[c] + curvature_at(target, point)});
        }
    }



    template <int dim>
    bool
    OverlapSearch<dim>::ends(const PlacedTarget<dim> &target) const
    {
      const double far = 1e6 * query_.body.largest_cell();
      for (unsigned int i = 0; i < Utilities::pow(3u, dim); ++i)
        {
          Point<dim>   point = contactor_.positions[0];
          unsigned int rest  = i;
          for (unsigned int d = 0; d < dim; ++d, rest /= 3)
            point[d] += far * (double(rest % 3) - 1.);
          if (point != contactor_.positions[0] &&
              !(closest(target, point).gap > 0.))
            return false;
        }
      return true;
    }



    template <int dim>
    double
    OverlapSearch<dim>::curvature_at(const PlacedTarget<dim> &target,
                                     const Point<dim>        &point) const
    {
      const auto found = closest(target, point);
      double     sum   = 0.;
      if (!found.curvature.empty())
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            sum += found.curvature(i, j) * found.curvature(i, j);
      return std::sqrt(sum);
    }
  } // namespace



  template <int dim>
  std::vector<Overlap<dim>>
  find_overlaps(const OverlapQuery<dim> &query)
  {
    return OverlapSearch<dim>(query).find();
  }



#define INSTANTIATE(dim) \
  template std::vector<Overlap<dim>> find_overlaps(const OverlapQuery<dim> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
