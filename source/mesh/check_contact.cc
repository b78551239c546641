// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_contact.h>
#include <ringmotor/mesh/check_section.h>
#include <ringmotor/mesh/contact_line.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/mesh_file.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/shell_line.h>
#include <ringmotor/parameters/check_geometry.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/parameters/prm_file.h>
#include <ringmotor/parameters/required.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** A body with its contact line and how messages name them. */
    struct BodyInContact
    {
      RevolvedBody body;
      std::string file_entry, file; ///< empty: of dimensions
      std::string inner, outer;     ///< entries of the contact line's radii
      types::boundary_id contact;
      ContactLine line = contact_line(body);

      [[noreturn]] void refuse(const std::string &found, const std::string &what_to_do) const
      {
        MeshFile{file, file_entry, ""}.refuse(found, what_to_do);
      }

      /** Where it can touch. */
      std::string in_words() const
      {
        return file.empty()
                   ? entry(inner, line.radii.inner) + " to " + entry(outer, line.radii.outer)
                   : "the curve 'contact' of " + file_entry + " = " + in_quotes(file) +
                         " from r = " + in_millimetres(line.radii.inner) + " to " +
                         in_millimetres(line.radii.outer);
      }
    };

    BodyInContact stator_of(const Parameters &parameters)
    {
      return {stator_body(parameters),   "Stator/Section file",     parameters.stator.section_file,
              "Stator/Tip inner radius", "Stator/Tip outer radius", ids::tooth_top};
    }

    BodyInContact rotor_of(const Parameters &parameters)
    {
      return {rotor_body(parameters),   "Rotor/Section file",     parameters.rotor.section_file,
              "Rotor/Lip inner radius", "Rotor/Lip outer radius", ids::lip};
    }

    /** One level line, which dimensions always give. */
    void check_line(const BodyInContact &body)
    {
      if (body.file.empty())
        return;
      const Section &section = body.body.section;
      if (body.line.radii.is_empty())
        body.refuse("it has no curve 'contact'",
                    body.contact == ids::lip
                        ? "name the lower face of lip or lining: Physical Curve(\"contact\")"
                        : "contact needs teeth: name their metal, Physical Surface(\"tooth\"), and "
                          "their tops, Physical Curve(\"contact\")");
      if (section.shell.n_in_contact == 0 && !is_one_line(section.edges_named(body.contact)))
        body.refuse("the curve 'contact' is in pieces", "name one line from end to end");
      if (body.line.highest - body.line.lowest > places::file_rounding * body.line.radii.outer)
        body.refuse("the curve 'contact' reaches from z = " + in_millimetres(body.line.lowest) +
                        " to " + in_millimetres(body.line.highest),
                    "name the part of it that is level, crowned or conical up to a tenth of its "
                    "width");
    }

    /** The edges that a rotor from a file must have, and those that it must not have. */
    void check_loads(const BodyInContact &rotor)
    {
      const auto has = [&](const types::boundary_id name)
      { return !rotor.body.section.edges_named(name).empty(); };
      if (rotor.file.empty())
        return;
      if (!has(ids::ring_top))
        rotor.refuse("it has no curve 'pressed'", "name the face on which the preload acts: "
                                                  "Physical Curve(\"pressed\")");
      if (!has(ids::ring_bore))
        rotor.refuse("it has no curve 'driven'", "name the face on which the load torque acts: "
                                                 "Physical Curve(\"driven\")");
      if (has(ids::clamped))
        rotor.refuse("it has the curve 'clamped'",
                     "leave it out for the program contact, where the rotor rises and turns; name "
                     "what centres it 'bars'");
    }

    void check_overlap(const BodyInContact &stator, const BodyInContact &rotor)
    {
      constexpr double narrowest = 1e-5; // m
      if (stator.line.radii.common(rotor.line.radii).width() < narrowest)
        throw UserError("the lip misses the teeth: " + rotor.in_words() + ", and " +
                        stator.in_words() + "; allowed: at least 10 um in common");
    }

    /** Two outlines in one plane. */
    class Penetration
    {
    public:
      Penetration(const Section &stator, Section rotor, const double rise)
          : stator(stator), rotor(std::move(rotor))
      {
        for (Point<2> &x : this->rotor.points)
          x[1] += rise;
        for (const Point<2> &x : stator.points)
          close = std::max(close, 2. * places::file_rounding * x[0]);
      }

      /** Where one body lies in the other, if it does. */
      std::optional<Point<2>> place() const
      {
        for (const auto &[one, other] :
             {std::make_pair(&rotor, &stator), std::make_pair(&stator, &rotor)})
          for (const Point<2> &x : outline(*one))
            for (const Section::Cell &cell : other->cells)
              if (is_inside(x, cell, *other))
                return x;
        return {};
      }

    private:
      /** Points on the outer edges, close enough to find what cuts in between. */
      static std::vector<Point<2>> outline(const Section &section)
      {
        constexpr unsigned int n = 16;
        std::vector<Point<2>> points;
        for (const auto &[edge, cells] : section.cells_at_edges())
          for (unsigned int i = 0; i <= n && cells.size() == 1; ++i)
          {
            const double share = static_cast<double>(i) / n;
            points.push_back(section.points[edge.first] +
                             share * (section.points[edge.second] - section.points[edge.first]));
          }
        return points;
      }

      bool is_inside(const Point<2> &x, const Section::Cell &cell, const Section &section) const
      {
        for (unsigned int i = 0; i < 4; ++i)
        {
          const Point<2> &from     = section.points[cell.corners[i]];
          const Tensor<1, 2> along = section.points[cell.corners[(i + 1) % 4]] - from,
                             to    = x - from;
          if (along[0] * to[1] - along[1] * to[0] <= close * along.norm())
            return false;
        }
        return true;
      }

      const Section &stator;
      Section rotor;
      double close = 0.; ///< m
    };

    void check_penetration(const BodyInContact &stator, const BodyInContact &rotor)
    {
      if (rotor.file.empty() && stator.file.empty()) // see check_clearance()
        return;
      const Penetration penetration(
          stator.body.section, with_cells_for_shell(rotor.body.section, rotor.body.shell_thickness),
          rise_to_contact(rotor.body, stator.body));
      if (const auto place = penetration.place())
        throw UserError("the rotor cuts into the stator, at " + in_words(*place) +
                        " (with the rotor on the tooth tops): " + rotor.in_words() + ", and " +
                        stator.in_words() + "; allowed: bodies that touch along these lines only");
    }

    void check_history(const Parameters &parameters, const RadialRange &touching)
    {
      for (const HistoryPoint &point : parameters.output.history_points)
      {
        std::ostringstream text;
        text << "Output/History points: ";
        if (point.radius < touching.inner || point.radius > touching.outer)
          text << "radius " << point.radius
               << " m is not where lip and teeth can touch; allowed: " << touching.inner << " to "
               << touching.outer << " m";
        else if (point.tooth >= parameters.motor.n_teeth)
          text << "tooth " << point.tooth << " is not on the ring; allowed: from 0 to less than "
               << parameters.motor.n_teeth << " (Motor/Number of teeth)";
        else
          continue;
        throw UserError(text.str());
      }
    }

    /** The rotor's damping is that of all its parts. */
    void check_loss_factor(const Parameters &parameters, const BodyInContact &body,
                           const types::material_id part, const std::string &material)
    {
      if (body.body.section.has_part(part))
        check_given(parameters, body.file_entry + " has the part '" + name_of_part(part) + "'",
                    {"Materials/" + material + "/Loss factor"});
    }
  } // namespace

  void check_bodies_in_contact(const Parameters &parameters)
  {
    const BodyInContact stator = stator_of(parameters), rotor = rotor_of(parameters);
    check_bodies(parameters);
    check_line(stator);
    check_line(rotor);
    check_loads(rotor);
    check_overlap(stator, rotor);
    check_penetration(stator, rotor);
    check_history(parameters, stator.line.radii.common(rotor.line.radii));
    check_loss_factor(parameters, rotor, ids::lining, "Lining");
    check_loss_factor(parameters, rotor, ids::adhesive, "Adhesive");
  }

  namespace
  {
    /** The felt, where it is given, against the stator above it. */
    std::vector<std::string> warnings_of_felt(const Support &felt, const RevolvedBody &stator)
    {
      if (!felt.has_felt())
        return {};
      const std::vector<RadialRange> ranges = radii_on_felt(stator);
      if (ranges.empty())
        return {"the section Support has a felt, but Stator/Section file has no curve 'felt' that "
                "lies on it: its loss is zero"};
      const RadialRange body{ranges.front().inner, ranges.back().outer},
          given{felt.felt_inner_radius.value_or(body.inner),
                felt.felt_outer_radius.value_or(body.outer)};
      if (given.is_empty())
        throw UserError(entry("Support/Felt inner radius", given.inner) + " is not below " +
                        entry("Support/Felt outer radius", given.outer) +
                        "; allowed: inner radius < outer radius");
      if (given.common(body).is_empty())
        return {"the felt (Support/Felt inner radius to Felt outer radius) is not under the "
                "stator: its loss is zero"};
      if (given.inner < body.inner || given.outer > body.outer)
        return {"the felt (Support/Felt inner radius to Felt outer radius) reaches beyond the "
                "stator: that part is ignored"};
      return {};
    }
  } // namespace

  std::vector<std::string> check_bodies_for_losses(const Parameters &parameters)
  {
    check_bodies_in_contact(parameters);
    const RevolvedBody stator = stator_body(parameters);
    if (stator.section.has_part(ids::piezoceramic) || stator.skin_thickness > 0.)
      check_given(parameters,
                  "losses needs the loss factor of each material, 0 for one without loss",
                  {"Materials/Piezoceramic/Loss factor"});
    return warnings_of_felt(parameters.support, stator);
  }
} // namespace ringmotor
