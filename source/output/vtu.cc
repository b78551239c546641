// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/lattice_output.h>
#include <ringmotor/output/ring_grid.h>
#include <ringmotor/output/vtu.h>
#include <ringmotor/pictures/turned.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

using namespace dealii;

namespace ringmotor
{
  namespace
  {
    using Vector = std::array<std::complex<double>, 3>;

    /** Components (radial, towards +theta, axial) at a place. */
    Vector cylindrical(const Vector &vector, const Point<3> &place)
    {
      const double radius = std::hypot(place[0], place[1]);
      return turned(vector, place[0] / radius, -place[1] / radius);
    }
  } // namespace

  void write_sector(const std::string &path, const SectorField &field)
  {
    std::vector<FieldName> names{{"displacement_real", 3, "m"},
                                 {"displacement_imaginary", 3, "m"},
                                 {"amplitude_radial", 1, "m"},
                                 {"amplitude_tangential", 1, "m"},
                                 {"amplitude_axial", 1, "m"},
                                 {"strain_energy", 1, "J/m^3"},
                                 {"material", 1, ""}};
    const bool has_potential =
        std::any_of(field.cells.begin(), field.cells.end(),
                    [](const SectorField::Cell &cell) { return !cell.potential.empty(); });
    if (has_potential)
      names.insert(names.end(), {{"potential_real", 1, "V"}, {"potential_imaginary", 1, "V"}});
    LatticeOutput<3> output(names, field.order);
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
        data(9, point)  = cell.strain_energy[point];
        data(10, point) = cell.material;
        if (has_potential)
        {
          const std::complex<double> phi = cell.potential.empty() ? 0. : cell.potential[point];
          data(11, point)                = phi.real();
          data(12, point)                = phi.imag();
        }
      }
    }
    output.write(path);
  }

  void write_ring_animation(const std::string &path, const SectorField &field,
                            const unsigned int n_frames)
  {
    Assert(field.angular_frequency > 0., ExcMessage("A motion needs a frequency."));
    const std::string record    = path + ".pvd";
    const std::string base_name = std::filesystem::path(path).filename();
    // A record of an earlier run must not remain beside frames of this one.
    std::remove(record.c_str());

    const RingGrid ring(field);
    const double period = 2. * numbers::PI / field.angular_frequency;
    std::vector<std::pair<double, std::string>> times_and_names;
    for (unsigned int frame = 0; frame < n_frames; ++frame)
    {
      const double fraction    = static_cast<double>(frame) / n_frames;
      const std::string ending = "_" + Utilities::int_to_string(frame, 2) + ".vtu";
      ring.write(path + ending, 2. * numbers::PI * fraction, Warp());
      times_and_names.emplace_back(fraction * period, base_name + ending);
    }
    write_pvd(record, times_and_names);
  }

  void write_ring_at(const std::string &path, const SectorField &field, const double time,
                     const Warp &warp)
  {
    RingGrid(field).write(path, field.angular_frequency * time, warp);
  }

  void write_ring_scalar(const std::string &path, const SectorField &field, const FieldName &name,
                         const std::vector<std::vector<double>> &values)
  {
    LatticeOutput<3> output({name, {"material", 1, ""}}, field.order);
    output.reserve(field.n_sectors * field.cells.size());
    for (unsigned int sector = 0; sector < field.n_sectors; ++sector)
    {
      const double angle = 2. * numbers::PI * sector / field.n_sectors;
      for (std::size_t cell = 0; cell < field.cells.size(); ++cell)
      {
        std::vector<Point<3>> points;
        for (const Point<3> &point : field.cells[cell].points)
          points.push_back(turned(point, std::cos(angle), std::sin(angle)));
        auto &data = output.add_patch(points).data;
        for (unsigned int point = 0; point < points.size(); ++point)
        {
          data(0, point) = values[cell][point];
          data(1, point) = field.cells[cell].material;
        }
      }
    }
    output.write(path);
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
