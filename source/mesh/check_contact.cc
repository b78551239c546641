// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/mesh/check_contact.h>
#include <ringmotor/mesh/check_section.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/mesh_file.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/shell_line.h>
#include <ringmotor/parameters/check_geometry.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/parameters/required.h>

#include <algorithm>
#include <optional>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** A body with its contact line and how messages name it. */
    struct BodyInContact
    {
      const BodyShape &shape;
      std::string inner, outer; ///< entries of the contact line's radii
      ContactLine line = shape.contact_line();

      const BodyOrigin &origin() const { return shape.origin; }

      /** Where it can touch. */
      std::string in_words() const
      {
        return origin().has_dimensions()
                   ? entry(inner, line.radii.inner) + " to " + entry(outer, line.radii.outer)
                   : "the " + origin().face() + " 'contact' of " + origin().text() +
                         " from r = " + in_millimetres(line.radii.inner) + " to " +
                         in_millimetres(line.radii.outer);
      }

      void expect_face(const types::boundary_id name, const std::string &what) const
      {
        if (!shape.has_face(name))
          origin().refuse("it has no " + origin().face() + " '" + name_of_edge(name) + "'",
                          "name " + what + ": " + origin().naming_of_face(name_of_edge(name)));
      }
    };

    /** Half of one sector, which is condensed with the symmetry of its mirror plane. */
    void check_form(const BodyShape &body)
    {
      if (body.form() == SectorForm::whole)
        body.origin.refuse("it is a whole sector, between two cuts",
                           "contact needs the half of it between a mirror plane, theta = 0, and a "
                           "cut; the modes of the stator alone need none, see the program stator");
    }

    /** One level face, which dimensions always give. */
    void check_stator(const BodyInContact &stator, const StatorShape &shape)
    {
      if (stator.origin().has_dimensions())
        return;
      check_form(shape);
      const bool has_contact = !stator.line.radii.is_empty();
      if (!has_contact || !shape.has_slots())
        stator.origin().refuse(has_contact ? "there is no slot between its teeth"
                                           : "it has no " + stator.origin().face() + " 'contact'",
                               "contact needs teeth: name their metal, " +
                                   stator.origin().naming_of_part("tooth") + ", and their tops, " +
                                   stator.origin().naming_of_face("contact"));
    }

    void check_line(const BodyInContact &body)
    {
      if (body.origin().has_dimensions())
        return;
      if (!body.shape.has_whole_contact())
        body.origin().refuse("the " + body.origin().face() + " 'contact' is in pieces",
                             "name one face from end to end");
      if (body.line.highest - body.line.lowest > places::file_rounding * body.line.radii.outer)
        body.origin().refuse("the " + body.origin().face() +
                                 " 'contact' reaches from z = " + in_millimetres(body.line.lowest) +
                                 " to " + in_millimetres(body.line.highest),
                             "name the part of it that is level, crowned or conical up to a tenth "
                             "of its width");
    }

    /** The faces that a rotor from a file must have, and those that it must not have. */
    void check_rotor_of_file(const BodyInContact &rotor)
    {
      if (rotor.origin().has_dimensions())
        return;
      check_form(rotor.shape);
      rotor.expect_face(ids::lip, "the lower face of lip or lining");
      rotor.expect_face(ids::ring_top, "the face on which the preload acts");
      rotor.expect_face(ids::ring_bore, "the face on which the load torque acts");
      if (rotor.shape.has_face(ids::clamped))
        rotor.origin().refuse("it has the " + rotor.origin().face() + " 'clamped'",
                              "leave it out for the program contact, where the rotor rises and "
                              "turns; name what centres it 'bars'");
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
      Penetration(Meridian of_stator, Meridian of_rotor, const double rise)
          : stator(std::move(of_stator)), rotor(std::move(of_rotor))
      {
        for (Point<2> &x : rotor.outline)
          x[1] += rise;
        for (std::vector<Point<2>> &cell : rotor.cells)
          for (Point<2> &x : cell)
            x[1] += rise;
        for (const Point<2> &x : stator.outline)
          close = std::max(close, 2. * places::file_rounding * x[0]);
      }

      /** Where one body lies in the other, if it does. */
      std::optional<Point<2>> place() const
      {
        for (const auto &[one, other] :
             {std::make_pair(&rotor, &stator), std::make_pair(&stator, &rotor)})
          for (const Point<2> &x : one->outline)
            for (const std::vector<Point<2>> &cell : other->cells)
              if (is_inside(x, cell))
                return x;
        return {};
      }

    private:
      bool is_inside(const Point<2> &x, const std::vector<Point<2>> &cell) const
      {
        for (std::size_t i = 0; i < cell.size(); ++i)
        {
          const Point<2> &from     = cell[i];
          const Tensor<1, 2> along = cell[(i + 1) % cell.size()] - from, to = x - from;
          if (along[0] * to[1] - along[1] * to[0] <= close * along.norm())
            return false;
        }
        return true;
      }

      Meridian stator, rotor;
      double close = 0.; ///< m
    };

    void check_penetration(const BodyInContact &stator, const BodyInContact &rotor)
    {
      if (rotor.origin().has_dimensions() && stator.origin().has_dimensions())
        return; // see check_clearance()
      const Penetration penetration(stator.shape.meridian(), rotor.shape.meridian(),
                                    rise_to_contact(rotor.shape, stator.shape));
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
    void check_loss_factor(const Parameters &parameters, const BodyShape &body,
                           const types::material_id part, const std::string &material)
    {
      if (body.has_part(part))
        check_given(parameters, body.origin.entry + " has the part '" + name_of_part(part) + "'",
                    {"Materials/" + material + "/Loss factor"});
    }

    void check_pair(const Parameters &parameters, const StatorShape &of_stator,
                    const RotorShape &of_rotor)
    {
      const BodyInContact stator{of_stator, "Stator/Tip inner radius", "Stator/Tip outer radius"},
          rotor{of_rotor, "Rotor/Lip inner radius", "Rotor/Lip outer radius"};
      check_stator(stator, of_stator);
      check_line(stator);
      check_rotor_of_file(rotor);
      check_line(rotor);
      check_overlap(stator, rotor);
      check_penetration(stator, rotor);
      check_history(parameters, stator.line.radii.common(rotor.line.radii));
      check_loss_factor(parameters, of_rotor, ids::lining, "Lining");
      check_loss_factor(parameters, of_rotor, ids::adhesive, "Adhesive");
    }
  } // namespace

  void check_bodies_in_contact(const Parameters &parameters)
  {
    check_bodies(parameters);
    check_pair(parameters, *stator_shape(parameters), *rotor_shape(parameters));
  }

  namespace
  {
    /** The felt, where it is given, against the stator above it. */
    std::vector<std::string> warnings_of_felt(const Support &felt, const StatorShape &stator)
    {
      if (!felt.has_felt())
        return {};
      const std::vector<RadialRange> ranges = stator.on_felt();
      if (ranges.empty())
        return {"the section Support has a felt, but " + stator.origin.entry + " has no " +
                stator.origin.face() + " 'felt' that lies on it: its loss is zero"};
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
    const auto stator = stator_shape(parameters);
    if (stator->has_part(ids::piezoceramic))
      check_given(parameters,
                  "losses needs the loss factor of each material, 0 for one without loss",
                  {"Materials/Piezoceramic/Loss factor"});
    return warnings_of_felt(parameters.support, *stator);
  }
} // namespace ringmotor
