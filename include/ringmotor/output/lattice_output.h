// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/files.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/reference_cell.h>

#include <string>
#include <tuple>
#include <vector>

namespace ringmotor
{
  /** A field of a VTU file: a scalar or a vector, in consecutive rows of the patches' data. */
  struct FieldName
  {
    std::string name;
    unsigned int n_components;
    std::string unit;
  };

  /** Hands patches, made elsewhere, to the VTU writer of deal.II, which turns them into Lagrange
   * cells: hexahedra, or quadrilaterals in space. */
  template <int dim>
  class LatticeOutput : public dealii::DataOutInterface<dim, 3>
  {
  public:
    using Patch = dealii::DataOutBase::Patch<dim, 3>;

    /** @param order points per direction of each patch, minus one */
    LatticeOutput(const std::vector<FieldName> &fields, const unsigned int order)
        : n_points(dealii::Utilities::fixed_power<dim>(order + 1)), order(order)
    {
      dealii::DataOutBase::VtkFlags flags;
      for (const FieldName &field : fields)
      {
        if (field.n_components == 3)
          ranges.emplace_back(names.size(), names.size() + 2, field.name,
                              dealii::DataComponentInterpretation::component_is_part_of_vector);
        names.insert(names.end(), field.n_components, field.name);
        if (!field.unit.empty())
          flags.physical_units[field.name] = field.unit;
      }
      flags.print_date_and_time      = false;
      flags.write_higher_order_cells = true;
      flags.compression_level        = dealii::DataOutBase::VtkFlags::best_speed;
      this->set_flags(flags);
    }

    void reserve(const std::size_t n_patches) { patches.reserve(n_patches); }

    /** Appends a patch without data. @param points of a lattice, first index fastest */
    Patch &add_patch(const std::vector<dealii::Point<3>> &points)
    {
      AssertDimension(points.size(), n_points);
      patches.emplace_back();
      Patch &patch               = patches.back();
      patch.patch_index          = patches.size() - 1;
      patch.n_subdivisions       = order;
      patch.points_are_available = true;
      patch.reference_cell       = dealii::ReferenceCells::get_hypercube<dim>();
      patch.data.reinit(names.size() + 3, n_points);

      // The lattice's corners; positions inside follow in the last three rows of the data.
      for (unsigned int corner = 0; corner < dealii::GeometryInfo<dim>::vertices_per_cell; ++corner)
      {
        const unsigned int i = corner & 1, j = (corner >> 1) & 1, k = corner >> 2;
        patch.vertices[corner] = points[order * (i + (order + 1) * (j + (order + 1) * k))];
      }
      for (unsigned int point = 0; point < n_points; ++point)
        for (unsigned int d = 0; d < 3; ++d)
          patch.data(names.size() + d, point) = points[point][d];
      return patch;
    }

    Patch &patch(const std::size_t index) { return patches[index]; }

    void write(const std::string &path) const
    {
      write_file(path, [this](std::ostream &out) { this->write_vtu(out); });
    }

  private:
    using Range = std::tuple<unsigned int, unsigned int, std::string,
                             dealii::DataComponentInterpretation::DataComponentInterpretation>;

    const std::vector<Patch> &get_patches() const override { return patches; }
    std::vector<std::string> get_dataset_names() const override { return names; }
    std::vector<Range> get_nonscalar_data_ranges() const override { return ranges; }

    const unsigned int n_points, order;
    std::vector<std::string> names;
    std::vector<Range> ranges;
    std::vector<Patch> patches;
  };
} // namespace ringmotor
