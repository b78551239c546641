// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/vtu.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <deal.II/grid/reference_cell.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

using namespace dealii;

namespace ringmotor
{
  namespace
  {
    using Vector = std::array<std::complex<double>, 3>;

    /** One field of the file: a scalar or a vector, in consecutive rows of the patches' data. */
    struct FieldName
    {
      std::string name;
      unsigned int n_components;
      std::string unit;
    };

    /** Hands patches, made elsewhere, to the VTU writer of deal.II. */
    class LatticeOutput : public DataOutInterface<3, 3>
    {
    public:
      /** @param order points per direction of each patch less one */
      LatticeOutput(const std::vector<FieldName> &fields, const unsigned int order)
          : n_points(Utilities::fixed_power<3>(order + 1)), order(order)
      {
        std::map<std::string, std::string> units;
        for (const FieldName &field : fields)
        {
          if (field.n_components == 3)
            ranges.emplace_back(names.size(), names.size() + 2, field.name,
                                DataComponentInterpretation::component_is_part_of_vector);
          names.insert(names.end(), field.n_components, field.name);
          if (!field.unit.empty())
            units[field.name] = field.unit;
        }
        DataOutBase::VtkFlags flags;
        flags.print_date_and_time      = false;
        flags.write_higher_order_cells = true;
        flags.compression_level        = DataOutBase::VtkFlags::best_speed;
        flags.physical_units           = units;
        set_flags(flags);
      }

      void reserve(const std::size_t n_patches) { patches.reserve(n_patches); }

      /** Appends a patch without data. @param points in the lattice order of SectorField */
      DataOutBase::Patch<3, 3> &add_patch(const std::vector<Point<3>> &points)
      {
        AssertDimension(points.size(), n_points);
        patches.emplace_back();
        auto &patch                = patches.back();
        patch.patch_index          = patches.size() - 1;
        patch.n_subdivisions       = order;
        patch.points_are_available = true;
        patch.reference_cell       = ReferenceCells::Hexahedron;
        patch.data.reinit(names.size() + 3, n_points);

        // The lattice's corners; positions inside follow in the last three rows of the data.
        for (unsigned int corner = 0; corner < GeometryInfo<3>::vertices_per_cell; ++corner)
        {
          const unsigned int i = corner & 1, j = (corner >> 1) & 1, k = corner >> 2;
          patch.vertices[corner] = points[order * (i + (order + 1) * (j + (order + 1) * k))];
        }
        for (unsigned int point = 0; point < n_points; ++point)
          for (unsigned int d = 0; d < 3; ++d)
            patch.data(names.size() + d, point) = points[point][d];
        return patch;
      }

      DataOutBase::Patch<3, 3> &patch(const std::size_t index) { return patches[index]; }

      void write(const std::string &path) const
      {
        write_file(path, [this](std::ostream &out) { write_vtu(out); });
      }

    private:
      const std::vector<DataOutBase::Patch<3, 3>> &get_patches() const override { return patches; }
      std::vector<std::string> get_dataset_names() const override { return names; }
      std::vector<std::tuple<unsigned int, unsigned int, std::string,
                             DataComponentInterpretation::DataComponentInterpretation>>
      get_nonscalar_data_ranges() const override
      {
        return ranges;
      }

      const unsigned int n_points, order;
      std::vector<std::string> names;
      std::vector<std::tuple<unsigned int, unsigned int, std::string,
                             DataComponentInterpretation::DataComponentInterpretation>>
          ranges;
      std::vector<DataOutBase::Patch<3, 3>> patches;
    };

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
      LatticeOutput output;
    };
  } // namespace

  void write_sector(const std::string &path, const SectorField &field)
  {
    LatticeOutput output({{"displacement_real", 3, "m"},
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
               [&](std::ostream &out) { DataOutBase::write_pvd_record(out, times_and_names); });
  }
} // namespace ringmotor
