// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/relevant.h>
#include <ringmotor/output/contact_h5.h>
#include <ringmotor/output/hdf5.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/points/error_cause.h>
#include <ringmotor/points/point_quantities.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    std::string group_of(const unsigned int point)
    {
      return "points/" + Utilities::int_to_string(point, 3);
    }

    std::string attribute_of(const PointQuantity &quantity)
    {
      return name_with_unit(quantity.name, quantity.unit.si);
    }

    std::string group_of(const std::string &point, const std::string &cause)
    {
      return point + "/errors/" + cause;
    }

    void write_errors(Hdf5Writer &file, const std::string &group, const CurvePoint &point)
    {
      for (const auto &[cause, error] : point.errors)
        for (const PointQuantity &quantity : point_quantities())
          if (quantity.has_own_error())
            file.set_attribute(group_of(group, cause), attribute_of(quantity),
                               error[quantity.name]);
    }

    std::map<std::string, PointError> read_errors(const Hdf5Reader &file, const std::string &group)
    {
      std::map<std::string, PointError> errors;
      for (const auto &cause : all_error_causes())
        for (const PointQuantity &quantity : point_quantities())
          if (quantity.has_own_error())
            errors[cause->name][quantity.name] =
                file.attribute<double>(group_of(group, cause->name), attribute_of(quantity));
      return errors;
    }

    std::vector<double> flat(const std::vector<PointVector> &vectors)
    {
      std::vector<double> numbers;
      for (const PointVector &vector : vectors)
        numbers.insert(numbers.end(), {vector[0], vector[1], vector[2]});
      return numbers;
    }

    void write_point(Hdf5Writer &file, const std::string &group, const CurvePoint &point,
                     const std::size_t n_nodes)
    {
      const ContactFields &fields = point.fields;
      file.set_attribute(group, "control", prescribed(point.request).name);
      file.set_attribute(group, "asked_for", point.request.value);
      for (const PointQuantity &quantity : point_quantities())
        file.set_attribute(group, attribute_of(quantity), quantity.value(point));
      write_errors(file, group, point);
      file.write(group + "/rotor_energy", point.rotor_energies, {point.rotor_energies.size()}, "J",
                 "strain energy of the rotor by multiple of the wave's frequency");
      file.set_attribute(group, "time_step_s", fields.time_step);
      file.write(group + "/time", fields.times, {fields.times.size()}, "s", "time samples");
      const std::vector<std::size_t> dims{fields.times.size(), fields.n_repeating_teeth, n_nodes,
                                          3};
      const std::string components = "; components: normal (up), along -theta, radial";
      file.write(group + "/force", flat(fields.state.force), dims, "N",
                 "force on the rotor by time sample, tooth, node" + components);
      file.write(group + "/gap_and_slip", flat(fields.motion), dims, "m",
                 "gap, and slip of the rotor over the stator in the step" + components);
      file.write(group + "/tooth", flat(fields.tooth), dims, "m",
                 "displacement of the teeth" + components);
      file.write(group + "/rotor", flat(fields.rotor), dims, "m",
                 "displacement of the rotor without its rigid rotation" + components);
      std::vector<unsigned int> status;
      for (const PointStatus of_point : fields.status)
        status.push_back(static_cast<unsigned int>(of_point));
      file.write(group + "/status", status,
                 {fields.times.size(), fields.n_repeating_teeth, n_nodes}, "1",
                 "0 open, 1 stick, 2 slip, by time sample, tooth, node");
    }

    /** What follows from the numbers that were read must be what the writer had.
     * @throws UserError if it is not */
    void require_same_derived(const Hdf5Reader &file, const std::string &path,
                              const std::string &group, CurvePoint &point)
    {
      constexpr double rounding = 1e-9;
      for (const PointQuantity &quantity : point_quantities())
        if (quantity.place(point) == nullptr)
        {
          const double written = file.attribute<double>(group, attribute_of(quantity)),
                       derived = quantity.value(point);
          if (!(std::abs(written - derived) <= rounding * std::max(std::abs(written), 1e-12)))
            throw UserError(path + ", " + group + ": " + quantity.name + " = " +
                            short_text(written) +
                            " does not follow from the other numbers, which "
                            "give " +
                            short_text(derived) + "; run the program contact again");
        }
    }

    CurvePoint read_point(const Hdf5Reader &file, const std::string &path, const std::string &group)
    {
      CurvePoint point;
      const bool of_torque = file.attribute<std::string>(group, "control") == "torque";
      point.request        = {of_torque ? Control::torque : Control::speed,
                       file.attribute<double>(group, "asked_for")};
      for (const PointQuantity &quantity : point_quantities())
        if (double *const place = quantity.place(point))
          *place = file.attribute<double>(group, attribute_of(quantity));
      require_same_derived(file, path, group, point);
      point.rotor_energies =
          file.read<double>(group + "/rotor_energy", {Hdf5Reader::any_size}, "J");
      point.errors = read_errors(file, group);
      return point;
    }
  } // namespace

  void write_contact_h5(const std::string &path, const Parameters &parameters,
                        const StatorWave &wave, const CondensedMotor &motor,
                        const std::vector<CurvePoint> &points)
  {
    Hdf5Writer file("ringmotor contact", contact_format_version);
    file.set_attribute("/", "motor", parameters.motor.name);
    file.set_attribute("/", "n_waves", motor.n_waves);
    file.set_attribute("/", "n_teeth", motor.n_teeth);
    file.set_attribute("/", "angular_frequency_rad_per_s", motor.wave.angular_frequency);
    file.set_attribute("/", "n_points", static_cast<unsigned int>(points.size()));
    file.set_attribute("/", "parameters", text_of(relevant_for_points(parameters)));
    file.set_attribute("/", "wave", wave.identity());
    std::vector<double> radius, angle, area, free_motion;
    for (const CondensedMotor::Node &node : motor.nodes)
    {
      radius.push_back(node.radius);
      angle.push_back(node.angle);
      area.push_back(node.area);
    }
    for (const auto &motion : motor.wave.free_motion)
      for (const std::complex<double> &component : motion)
        free_motion.insert(free_motion.end(), {component.real(), component.imag()});
    const std::vector<std::size_t> dims{motor.nodes.size()};
    file.write("nodes/radius", radius, dims, "m", "radius of the contact nodes of a tooth");
    file.write("nodes/angle", angle, dims, "rad", "their angle from the tooth's centre");
    file.write("nodes/area", area, dims, "m^2", "area of the tooth top assigned to them");
    file.write("nodes/free_motion", free_motion, {motor.nodes.size(), 3, 2}, "m",
               "real and imaginary part of their motion on tooth 0 without contact forces; "
               "components: normal (up), along -theta, radial");
    for (unsigned int p = 0; p < points.size(); ++p)
      write_point(file, group_of(p), points[p], motor.nodes.size());
    file.save(path);
  }

  std::vector<CurvePoint> read_contact_points(const std::string &path, const Parameters &parameters,
                                              const StatorWave &wave)
  {
    if (!std::filesystem::exists(path))
      throw UserError(path + " does not exist: the operating points are needed; run the program "
                             "contact with the same parameter file first");
    const Hdf5Reader file(path, "ringmotor contact", contact_format_version);
    const std::string other =
        difference(file.attribute<std::string>("/", "parameters"), relevant_for_points(parameters));
    if (!other.empty())
      throw UserError(path + " belongs to other parameters: " + other +
                      "; run the program contact with these parameters first");
    if (file.attribute<std::string>("/", "wave") != wave.identity())
      throw UserError(
          path +
          " belongs to another wave of the stator, or another drive of it, than the present one; "
          "run the program contact again");
    std::vector<CurvePoint> points;
    for (unsigned int p = 0; p < file.attribute<unsigned int>("/", "n_points"); ++p)
      points.push_back(read_point(file, path, group_of(p)));
    return points;
  }
} // namespace ringmotor
