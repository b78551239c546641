// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_section.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/section_layers.h>
#include <ringmotor/mesh/shell_line.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** m, what a file's points may be off. */
    double close_in(const Section &section)
    {
      double radius = 0.;
      for (const Point<2> &x : section.points)
        radius = std::max(radius, x[0]);
      return places::file_rounding * radius;
    }

    std::vector<Section::Edge> outer_edges(const Section &section)
    {
      std::vector<Section::Edge> outer;
      for (const auto &[edge, cells] : section.cells_at_edges())
        if (cells.size() == 1)
          outer.push_back(edge);
      return outer;
    }

    /** The point of an outer edge where this one is meant to lie, if there is one. */
    std::optional<Point<2>> on_outline(const Point<2> &x, const Section &section)
    {
      const double close = close_in(section);
      for (const Section::Edge &edge : outer_edges(section))
      {
        const Point<2> &begin    = section.points[edge.first];
        const Tensor<1, 2> along = section.points[edge.second] - begin;
        const double share       = std::clamp((x - begin) * along / along.norm_square(), 0., 1.);
        if (const Point<2> nearest(begin + share * along); nearest.distance(x) <= close)
          return nearest;
      }
      return {};
    }

    /** Puts the pieces of a curve into order. */
    class ShellCurve
    {
    public:
      ShellCurve(const std::vector<ShellPiece> &pieces, const std::vector<Point<2>> &places,
                 const Section &section, const MeshFile &file)
          : pieces(pieces), places(places), section(section), file(file)
      {
        for (unsigned int piece = 0; piece < pieces.size(); ++piece)
          for (const unsigned int node : {pieces[piece].nodes.first, pieces[piece].nodes.second})
            pieces_at[node].push_back(piece);
      }

      Section::ShellLine line()
      {
        std::vector<Section::Edge> edges;
        for (const ShellPiece &piece : pieces)
          edges.push_back(piece.nodes);
        if (!is_one_line(edges))
          file.refuse("the curve 'shell' is in pieces, or branches", "draw one line with two ends");
        follow(free_end());
        check();
        return merged();
      }

    private:
      unsigned int free_end()
      {
        std::vector<unsigned int> free;
        std::string ends;
        for (const auto &[node, of_node] : pieces_at)
          if (of_node.size() == 1)
          {
            ends += (ends.empty() ? "" : " and ") + in_words(places[node]);
            if (const auto place = on_outline(places[node], section))
              root = *place;
            else
              free.push_back(node);
          }
        if (free.size() != 1)
          file.refuse("the curve 'shell', with the ends " + ends + ", is tied to the body at " +
                          (free.empty() ? "both" : "neither"),
                      "let it lead from a free end to an outer edge of the surfaces");
        return free.front();
      }

      void follow(unsigned int at)
      {
        points           = {places[at]};
        unsigned int was = pieces.size();
        for (bool goes_on = true; goes_on;)
        {
          goes_on = false;
          for (const unsigned int piece : pieces_at.at(at))
            if (piece != was && !goes_on)
            {
              const auto &[a, b] = pieces[piece].nodes;
              at                 = at == a ? b : a;
              was                = piece;
              goes_on            = true;
              points.push_back(places[at]);
              in_contact.push_back(pieces[piece].in_contact);
            }
        }
        points.back() = root;
      }

      void check() const
      {
        for (unsigned int i = 0; i < in_contact.size(); ++i)
        {
          const Tensor<1, 2> along = points[i + 1] - points[i];
          const std::string where  = ", at " + in_words(points[i]);
          if (points[i][0] < 0.01 * root[0] || along[0] < std::abs(along[1]))
            file.refuse("the curve 'shell' does not lead outwards" + where,
                        "draw it from a free end with a smaller radius to the body, rising or "
                        "falling by 45 degrees at most");
          if (in_contact[i] && i > 0 && !in_contact[i - 1])
            file.refuse("the curve 'contact' on the shell does not begin at its free end" + where,
                        "let the free end touch, or no part of the shell");
          if (in_contact[i] && std::abs(along[1]) > close_in(section))
            file.refuse("the curve 'contact' on the shell is not level" + where,
                        "draw this part of it level");
        }
      }

      Section::ShellLine merged() const
      {
        Section::ShellLine line{{points.front()}, 0};
        for (unsigned int i = 0; i < in_contact.size(); ++i)
        {
          const Point<2> &end = points[i + 1];
          bool is_straight    = i > 0 && in_contact[i] == in_contact[i - 1];
          if (is_straight)
          {
            const Tensor<1, 2> a = line.points.back() - *std::prev(line.points.end(), 2),
                               b = end - line.points.back();
            is_straight = std::abs(a[0] * b[1] - a[1] * b[0]) <= close_in(section) * a.norm();
          }
          if (is_straight)
            line.points.back() = end;
          else
          {
            line.points.push_back(end);
            line.n_in_contact += in_contact[i] ? 1 : 0;
          }
        }
        return line;
      }

      const std::vector<ShellPiece> &pieces;
      const std::vector<Point<2>> &places;
      const Section &section;
      const MeshFile &file;
      std::map<unsigned int, std::vector<unsigned int>> pieces_at; ///< by node
      Point<2> root;
      std::vector<Point<2>> points; ///< from the free end to the root
      std::vector<bool> in_contact; ///< by piece between them
    };
  } // namespace

  Section::ShellLine shell_line(const std::vector<ShellPiece> &pieces,
                                const std::vector<Point<2>> &places, const Section &section,
                                const MeshFile &file)
  {
    return ShellCurve(pieces, places, section, file).line();
  }

  void name_shell_root(Section &section, const double thickness, const MeshFile &file)
  {
    const std::vector<Point<2>> &line = section.shell.points;
    const Point<2> end                = line.back();
    const Tensor<1, 2> span = end - *std::prev(line.end(), 2), along = span / span.norm();
    const Tensor<1, 2> across({-along[1], along[0]});
    const double close = close_in(section);
    double covered     = 0.;
    for (const Section::Edge &edge : outer_edges(section))
    {
      const Tensor<1, 2> a = section.points[edge.first] - end,
                         b = section.points[edge.second] - end;
      if (std::abs(a * along) > close || std::abs(b * along) > close)
        continue;
      const std::pair<double, double> ends = std::minmax({a * across, b * across});
      const double common =
          std::min(ends.second, 0.5 * thickness) - std::max(ends.first, -0.5 * thickness);
      if (common <= close)
        continue;
      covered += common;
      if (const auto [entry, is_new] = section.names.emplace(edge, ids::shell_root); !is_new)
        file.refuse("the edge that the curve 'shell' is tied to, at " + in_words(end) +
                        ", has the name '" + name_of_edge(entry->second) + "'",
                    "leave that edge without a name");
    }
    if (covered < thickness - 2. * close)
      file.refuse("the curve 'shell' ends at " + in_words(end) +
                      ", where no edge across it covers Rotor/Shell thickness = " +
                      in_millimetres(thickness),
                  "let it end in the middle of an edge at right angles to it that is as long as "
                  "the shell is thick, or longer");
  }

  double thinnest_with_shell(const Section &section, const double thickness)
  {
    std::set<unsigned int> at_root;
    for (const Section::Edge &edge : section.edges_named(ids::shell_root))
      at_root.insert({edge.first, edge.second});
    const SectionPoints corners = singular_points(section);
    double thinnest             = thickness;
    for (const auto &[edge, cells] : section.cells_at_edges())
      if (corners.count(edge.first) + corners.count(edge.second) > 0 &&
          at_root.count(edge.first) + at_root.count(edge.second) == 0)
        thinnest = std::min(thinnest, section.length(edge));
    return thinnest;
  }

  Section with_cells_for_shell(Section section, const double thickness)
  {
    const std::vector<Point<2>> line = section.shell.points;
    for (unsigned int i = 0; i + 1 < line.size(); ++i)
    {
      const Tensor<1, 2> along = line[i + 1] - line[i];
      const Tensor<1, 2> up = 0.5 * thickness / along.norm() * Tensor<1, 2>({-along[1], along[0]});
      const unsigned int first = section.points.size();
      section.points.insert(section.points.end(),
                            {line[i] - up, line[i + 1] - up, line[i + 1] + up, line[i] + up});
      section.cells.push_back({{{first, first + 1, first + 2, first + 3}}, ids::rotor});
    }
    section.shell = {};
    return section;
  }
} // namespace ringmotor
