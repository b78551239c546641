// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_sector.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Vertices = std::set<unsigned int>;

    /** The vertices of the faces that @p is_chosen(cell, number of the face). */
    template <typename Chosen>
    Vertices vertices_of(const SectorMesh &mesh, const Chosen &is_chosen)
    {
      Vertices vertices;
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
        for (const unsigned int face : cell->face_indices())
          if (is_chosen(cell, face))
            for (const unsigned int i : cell->face(face)->vertex_indices())
              vertices.insert(cell->face(face)->vertex_index(i));
      return vertices;
    }

    Vertices vertices_on(const SectorMesh &mesh, const types::boundary_id boundary)
    {
      return vertices_of(
          mesh, [&](const auto &cell, const unsigned int face)
          { return cell->at_boundary(face) && cell->face(face)->boundary_id() == boundary; });
    }

    /** Places of vertices, (r, theta, z), that many are meant to have in common. */
    class Places
    {
    public:
      explicit Places(const SectorMesh &mesh)
          : tolerance(places::file_rounding * range_of_radii(*mesh.triangulation).second)
      {
        for (const Point<3> &vertex : mesh.triangulation->get_vertices())
          place.push_back(cylindrical(vertex));
      }

      /** Moves all that are nearly at the lowest or highest place of these vertices, if there are
       * any, there. */
      void level(const Vertices &vertices, const unsigned int coordinate)
      {
        if (vertices.empty())
          return;
        const auto [low, high] =
            std::minmax_element(vertices.begin(), vertices.end(),
                                [&](const unsigned int a, const unsigned int b)
                                { return place[a][coordinate] < place[b][coordinate]; });
        for (const double level : {place[*low][coordinate], place[*high][coordinate]})
          move_to(level, coordinate);
      }

      /** Moves all that are nearly at a radius or height there. */
      void move_to(const double level, const unsigned int coordinate)
      {
        for (Point<3> &x : place)
          if (std::abs(x[coordinate] - level) <= tolerance)
            x[coordinate] = level;
      }

      void move_to_center()
      {
        for (Point<3> &x : place)
          if (std::abs(x[1]) * x[0] <= tolerance)
            x[1] = 0.;
      }

      Point<3> &operator[](const unsigned int vertex) { return place[vertex]; }

    private:
      const double tolerance; ///< m
      std::vector<Point<3>> place;
    };

    void move_to_levels(const SectorMesh &mesh, Places &places)
    {
      constexpr unsigned int r = 0, z = 2;
      const Vertices all     = vertices_of(mesh, [](const auto &, unsigned int) { return true; }),
                     ceramic = vertices_of(mesh, [](const auto &cell, unsigned int)
                                           { return cell->material_id() == ids::piezoceramic; }),
                     foot    = vertices_of(mesh,
                                           [](const auto &cell, const unsigned int face)
                                           {
                                          return cell->material_id() == ids::tooth &&
                                                 !cell->at_boundary(face) &&
                                                 cell->neighbor(face)->material_id() == ids::base;
                                        });
      places.level(vertices_on(mesh, ids::tooth_top), r);
      places.level(vertices_on(mesh, ids::lip), r);
      places.level(vertices_on(mesh, ids::lip), z);
      places.level(foot, r);
      places.level(foot, z);
      places.level(all, z);
      places.level(ceramic, z);
      if (!ceramic.empty())
        places.move_to(0., z);
    }

    void move_to_planes(const SectorMesh &mesh, Places &places)
    {
      const double half_pitch = numbers::PI / mesh.n_sectors;
      places.move_to_center();
      for (const unsigned int vertex : vertices_on(mesh, ids::cut))
        places[vertex][1] = half_pitch;
      const Vertices low = vertices_on(mesh, ids::cut_low);
      for (const unsigned int vertex : vertices_on(mesh, ids::cut_high))
      {
        const auto distance = [&](const unsigned int other)
        {
          return std::max(std::abs(places[other][0] - places[vertex][0]),
                          std::abs(places[other][2] - places[vertex][2]));
        };
        const unsigned int partner = *std::min_element(
            low.begin(), low.end(),
            [&](const unsigned int a, const unsigned int b) { return distance(a) < distance(b); });
        places[vertex] = places[partner];
        places[vertex][1] += 2. * half_pitch;
      }
    }
  } // namespace

  void move_to_exact_places(SectorMesh &mesh)
  {
    Places places(mesh);
    move_to_levels(mesh, places);
    move_to_planes(mesh, places);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const unsigned int i : cell->vertex_indices())
        cell->vertex(i) = cartesian(places[cell->vertex_index(i)]);
  }
} // namespace ringmotor
