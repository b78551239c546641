// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/output/body_vtu.h>
#include <ringmotor/output/contact_vtu.h>
#include <ringmotor/output/lattice_output.h>
#include <ringmotor/output/vtu.h>
#include <ringmotor/structure/shared_work.h>

#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The fields of a contact point except displacements. */
    const std::vector<FieldName> point_fields{{"pressure", 1, "Pa"},   {"friction_t", 1, "Pa"},
                                              {"friction_r", 1, "Pa"}, {"slip_velocity", 1, "m/s"},
                                              {"status", 1, ""},       {"gap", 1, "m"}};

    /** Their values, in this order. */
    std::array<double, 6> values_at(const CondensedMotor::Node &node, const ContactFields &fields,
                                    const std::size_t point)
    {
      const PointVector traction = fields.state.force[point] / node.area,
                        &motion  = fields.motion[point];
      return {{traction[0], traction[1], traction[2],
               std::hypot(motion[1], motion[2]) / fields.time_step,
               static_cast<double>(fields.status[point]), motion[0]}};
    }

    Tensor<1, 3> cartesian(const PointVector &vector, const double theta)
    {
      Tensor<1, 3> result; // components: z, -theta, r
      result[0] = vector[2] * std::cos(theta) + vector[1] * std::sin(theta);
      result[1] = vector[2] * std::sin(theta) - vector[1] * std::cos(theta);
      result[2] = vector[0];
      return result;
    }

    /** The contact points of a ring at one time sample. */
    class Snapshot
    {
    public:
      Snapshot(const CondensedMotor &motor, const ContactFields &fields, const double height)
          : motor(motor), fields(fields), height(height)
      {
      }

      double angle(const unsigned int tooth, const unsigned int node) const
      {
        return motor.nodes[node].angle + tooth * motor.pitch();
      }

      Point<3> place(const unsigned int tooth, const unsigned int node) const
      {
        const double r = motor.nodes[node].radius, theta = angle(tooth, node);
        return Point<3>(r * std::cos(theta), r * std::sin(theta), height);
      }

      /** The index in the fields, at the last time sample. */
      std::size_t point(const unsigned int tooth, const unsigned int node) const
      {
        return fields.point(fields.times.size() - 1, tooth, node);
      }

      const CondensedMotor &motor;
      const ContactFields &fields;

    private:
      const double height;
    };

    void write_surface(const std::string &path, const Snapshot &snapshot)
    {
      const CondensedMotor &motor   = snapshot.motor;
      std::vector<FieldName> fields = point_fields;
      fields.push_back({"displacement_tooth", 3, "m"});
      fields.push_back({"displacement_rotor", 3, "m"});
      LatticeOutput<2> output(fields, motor.degree);
      const std::vector<unsigned int> lattice =
          FETools::lexicographic_to_hierarchic_numbering<2>(motor.degree);
      for (unsigned int tooth = 0; tooth < motor.n_teeth; ++tooth)
        for (const std::vector<unsigned int> &face : motor.faces)
        {
          std::vector<Point<3>> places;
          for (const unsigned int q : lattice)
            places.push_back(snapshot.place(tooth, face[q]));
          auto &data = output.add_patch(places).data;
          for (unsigned int q = 0; q < places.size(); ++q)
          {
            const unsigned int a = face[lattice[q]];
            const std::size_t i  = snapshot.point(tooth, a);
            unsigned int row     = 0;
            for (const double value : values_at(motor.nodes[a], snapshot.fields, i))
              data(row++, q) = value;
            for (const PointVector &vector : {snapshot.fields.tooth[i], snapshot.fields.rotor[i]})
              for (unsigned int d = 0; d < 3; ++d)
                data(row++, q) = cartesian(vector, snapshot.angle(tooth, a))[d];
          }
        }
      output.write(path);
    }

    PointField displacement_field(const RingBody::Displacement &displacement)
    {
      PointField field{"displacement", "m", 3, {}};
      for (const Tensor<1, 3> &vector : displacement)
        for (unsigned int d = 0; d < 3; ++d)
          field.values.push_back(static_cast<float>(vector[d]));
      return field;
    }

    /** The fields of the contact points as fields of the teeth. */
    std::vector<PointField> fields_on_teeth(const RingBody &teeth, const Snapshot &snapshot)
    {
      std::vector<PointField> fields;
      for (const FieldName &field : point_fields)
        fields.push_back(
            {field.name, field.unit, 1,
             std::vector<float>(teeth.points().size(), field.name == "gap"
                                                           ? std::numeric_limits<float>::quiet_NaN()
                                                           : 0.f)});
      const CondensedMotor &motor = snapshot.motor;
      for (unsigned int tooth = 0; tooth < motor.n_teeth; ++tooth)
        for (unsigned int a = 0; a < motor.nodes.size(); ++a)
          if (const auto point = teeth.point_at(snapshot.place(tooth, a)))
          {
            const auto values =
                values_at(motor.nodes[a], snapshot.fields, snapshot.point(tooth, a));
            for (unsigned int field = 0; field < values.size(); ++field)
              fields[field].values[*point] = static_cast<float>(values[field]);
          }
      return fields;
    }

    /** What ParaView calls time: the torque in mN m, to the nearest uN m. */
    double torque_as_time(const CurvePoint &point)
    {
      return std::round(1e6 * point.result.torque) * 1e-3 + 0.;
    }

    std::string numbered(const std::string &name, const unsigned int number)
    {
      return name + "_" + Utilities::int_to_string(number, 3) + ".vtu";
    }

    /** Files of the stator below the teeth, one for each of its positions. */
    class BaseFiles
    {
    public:
      BaseFiles(const std::string &folder, const StatorAtWave &stator, const MPI_Comm ranks)
          : folder(folder), base(stator), ranks(ranks)
      {
        std::vector<SectorField::Cell> &cells = base.field.cells;
        cells.erase(std::remove_if(cells.begin(), cells.end(),
                                   [](const SectorField::Cell &cell)
                                   { return cell.material == ids::tooth; }),
                    cells.end());
        leave_corners_of_many_cells();
      }

      /** The name of that of a point at its last time sample, written if it is not there.
       * Collective. */
      std::string of(const CurvePoint &point)
      {
        const std::pair<double, double> position{point.result.amplitude, point.fields.times.back()};
        const std::size_t number   = names.size();
        const auto [known, is_new] = names.try_emplace(position, numbered("base", number));
        if (is_new && is_my_turn(number, ranks))
        {
          SectorField moved = base.field;
          for (SectorField::Cell &cell : moved.cells)
            for (auto &u : cell.displacement)
              for (std::complex<double> &component : u)
                component *= point.result.amplitude / base.amplitude;
          write_ring_at(folder + known->second, moved, point.fields.times.back(), base.warp);
        }
        return known->second;
      }

    private:
      /** Cells that are small compared to the picture show their motion by that of their corners;
       * with the points between these the files of all operating points would be huge. */
      void leave_corners_of_many_cells()
      {
        constexpr std::size_t most_points = 1000000; // of the whole ring
        SectorField &field                = base.field;
        const unsigned int order = field.order, width = order + 1;
        if (order == 1 ||
            field.cells.size() * width * width * width * field.n_sectors <= most_points)
          return;
        for (SectorField::Cell &cell : field.cells)
        {
          SectorField::Cell corners;
          corners.material = cell.material;
          for (const unsigned int k : {0u, order})
            for (const unsigned int j : {0u, order})
              for (const unsigned int i : {0u, order})
              {
                const unsigned int point = i + width * (j + width * k);
                corners.points.push_back(cell.points[point]);
                corners.displacement.push_back(cell.displacement[point]);
                corners.strain_energy.push_back(cell.strain_energy[point]);
              }
          cell = std::move(corners);
        }
        field.order = 1;
      }

      const std::string folder;
      StatorAtWave base;
      const MPI_Comm ranks;
      std::map<std::pair<double, double>, std::string> names; ///< by amplitude (m) and time (s)
    };
  } // namespace

  void write_contact_surfaces(const std::string &folder, const CondensedMotor &motor,
                              const std::vector<CurvePoint> &points, const double height,
                              const MPI_Comm ranks)
  {
    std::vector<std::pair<double, std::string>> files;
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      files.emplace_back(torque_as_time(points[i]), numbered("contact", i));
      if (is_my_turn(i, ranks))
        write_surface(folder + files.back().second, {motor, points[i].fields, height});
    }
    if (is_my_turn(0, ranks))
      write_pvd(folder + "contact.pvd", files);
  }

  void write_motor_bodies(const std::string &folder, const CondensedMotor &motor,
                          const MotorBodies &bodies, const RotorVibration &vibration,
                          const StatorAtWave &stator, const std::vector<CurvePoint> &points,
                          const double height, const MPI_Comm ranks)
  {
    std::vector<PointSample> last, of_my_files;
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      const ContactFields &fields = points[i].fields;
      last.push_back(
          {fields, static_cast<unsigned int>(fields.times.size() - 1), points[i].result.amplitude});
      if (is_my_turn(i, ranks))
        of_my_files.push_back(last.back());
    }
    const std::vector<RingBody::Displacement> rotor = bodies.rotor_motions(motor, vibration, last),
                                              teeth = bodies.teeth_motions(of_my_files);
    auto my_teeth                                   = teeth.begin();
    BaseFiles base(folder, stator, ranks);
    std::vector<std::pair<double, std::string>> files;
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      const double time = torque_as_time(points[i]);
      for (const std::string body : {"rotor", "teeth"})
        files.emplace_back(time, numbered(body, i));
      files.emplace_back(time, base.of(points[i]));
      if (!is_my_turn(i, ranks))
        continue;
      write_body(folder + numbered("rotor", i), bodies.rotor(), {displacement_field(rotor[i])});
      std::vector<PointField> fields =
          fields_on_teeth(bodies.teeth(), {motor, points[i].fields, height});
      fields.insert(fields.begin(), displacement_field(*my_teeth++));
      write_body(folder + numbered("teeth", i), bodies.teeth(), fields);
    }
    if (is_my_turn(0, ranks))
      write_pvd(folder + "motor.pvd", files);
  }
} // namespace ringmotor
