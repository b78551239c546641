// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/lattice_output.h>
#include <ringmotor/output/vtu.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace dealii;

namespace ringmotor
{
  namespace
  {
    using Vector = std::array<std::complex<double>, 3>;

    /** A vector (a point, or complex) turned about the z axis. */
    template <typename VectorType>
    VectorType turned(const VectorType &vector, const double cosine, const double sine)
    {
      VectorType result = vector;
      result[0]         = cosine * vector[0] - sine * vector[1];
      result[1]         = sine * vector[0] + cosine * vector[1];
      return result;
    }

    /** Components (radial, towards +theta, axial) at a place. */
    Vector cylindrical(const Vector &vector, const Point<3> &place)
    {
      const double radius = std::hypot(place[0], place[1]);
      return turned(vector, place[0] / radius, -place[1] / radius);
    }

    /** All sectors with the displacement at one moment. */
    class Ring
    {
    public:
      explicit Ring(const SectorField &field)
          : field(field), output({{"displacement", 3, "m"}, {"material", 1, ""}}, field.order)
      {
        output.reserve(field.n_sectors * field.cells.size());
        for (unsigned int sector = 0; sector < field.n_sectors; ++sector)
        {
          const double angle = angle_of(sector), cosine = std::cos(angle), sine = std::sin(angle);
          for (const SectorField::Cell &cell : field.cells)
          {
            std::vector<Point<3>> points;
            for (const Point<3> &point : cell.points)
              points.push_back(turned(point, cosine, sine));
            auto &data = output.add_patch(points).data;
            for (unsigned int point = 0; point < points.size(); ++point)
              data(3, point) = cell.material;
          }
        }
      }

      /** @param time_angle omega t */
      void move_to(const double time_angle)
      {
        std::size_t index = 0;
        for (unsigned int sector = 0; sector < field.n_sectors; ++sector)
        {
          const double angle = angle_of(sector), cosine = std::cos(angle), sine = std::sin(angle);
          const auto phase = std::polar(1., time_angle - field.nodal_diameter * angle);
          for (const SectorField::Cell &cell : field.cells)
          {
            auto &data = output.patch(index++).data;
            for (unsigned int point = 0; point < cell.points.size(); ++point)
            {
              const Vector motion = turned(cell.displacement[point], cosine, sine);
              for (unsigned int d = 0; d < 3; ++d)
                data(d, point) = std::real(phase * motion[d]);
            }
          }
        }
      }

      void write(const std::string &path) const { output.write(path); }

    private:
      double angle_of(const unsigned int sector) const
      {
        return 2. * numbers::PI * sector / field.n_sectors;
      }

      const SectorField &field;
      LatticeOutput<3> output;
    };
  } // namespace

  void write_sector(const std::string &path, const SectorField &field)
  {
    LatticeOutput<3> output({{"displacement_real", 3, "m"},
                             {"displacement_imaginary", 3, "m"},
                             {"amplitude_radial", 1, "m"},
                             {"amplitude_tangential", 1, "m"},
                             {"amplitude_axial", 1, "m"},
                             {"material", 1, ""}},
                            field.order);
    output.reserve(field.cells.size());
    for (const SectorField::Cell &cell : field.cells)
    {
      auto &data = output.add_patch(cell.points).data;
      for (unsigned int point = 0; point < cell.points.size(); ++point)
      {
        const Vector &motion   = cell.displacement[point];
        const Vector amplitude = cylindrical(motion, cell.points[point]);
        for (unsigned int d = 0; d < 3; ++d)
        {
          data(d, point)     = motion[d].real();
          data(3 + d, point) = motion[d].imag();
          data(6 + d, point) = std::abs(amplitude[d]);
        }
        data(9, point) = cell.material;
      }
    }
    output.write(path);
  }

  void write_ring_animation(const std::string &folder, const std::string &base_name,
                            const SectorField &field, const unsigned int n_frames)
  {
    Assert(field.angular_frequency > 0., ExcMessage("A motion needs a frequency."));
    const std::string record = folder + "/" + base_name + ".pvd";
    // A record of an earlier run must not survive beside frames of this one.
    std::remove(record.c_str());

    Ring ring(field);
    const double period = 2. * numbers::PI / field.angular_frequency;
    std::vector<std::pair<double, std::string>> times_and_names;
    for (unsigned int frame = 0; frame < n_frames; ++frame)
    {
      const double fraction  = static_cast<double>(frame) / n_frames;
      const std::string name = base_name + "_" + Utilities::int_to_string(frame, 2) + ".vtu";
      ring.move_to(2. * numbers::PI * fraction);
      ring.write(folder + "/" + name);
      times_and_names.emplace_back(fraction * period, name);
    }
    write_pvd(record, times_and_names);
  }

  void write_pvd(const std::string &path,
                 const std::vector<std::pair<double, std::string>> &times_and_names)
  {
    write_file(path,
               [&](std::ostream &out)
               {
                 out.precision(12);
                 out << "<?xml version=\"1.0\"?>\n"
                     << "<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
                 unsigned int part = 0;
                 for (std::size_t i = 0; i < times_and_names.size(); ++i)
                 {
                   const auto &[time, name] = times_and_names[i];
                   part = i > 0 && time == times_and_names[i - 1].first ? part + 1 : 0;
                   out << "    <DataSet timestep=\"" << time << "\" part=\"" << part << "\" file=\""
                       << name << "\"/>\n";
                 }
                 out << "  </Collection>\n</VTKFile>\n";
               });
  }
} // namespace ringmotor
