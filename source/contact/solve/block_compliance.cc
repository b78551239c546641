// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/dense_product.h>
#include <ringmotor/contact/solve/block_compliance.h>

namespace ringmotor
{
  using namespace dealii;

  BlockCompliance::BlockCompliance(const RingCompliance &at_once, const unsigned int n_samples)
      : at_once(at_once), n_samples(n_samples)
  {
  }

  BlockCompliance::BlockCompliance(const RingCompliance &at_once, const unsigned int n_samples,
                                   RingCompliance modes, std::vector<unsigned int> instants)
      : at_once(at_once), n_samples(n_samples), of_modes(std::move(modes)),
        instant(std::move(instants))
  {
    AssertDimension(instant.size(), n_blocks());
    AssertDimension(of_modes.n_sectors(), n_blocks());
    if (!at_once.has_table() || !of_modes.is_small())
      return;
    whole                                             = of_modes.all_entries();
    const std::vector<FullMatrix<double>> same_sample = at_once.all_entries();
    for (unsigned int tooth = 0; tooth < same_sample.size(); ++tooth)
      whole[instants_between(tooth, 0)].add(1., same_sample[tooth]);
  }

  const RingCompliance::Far &BlockCompliance::far() const
  {
    if (instant.empty())
      return at_once.far();
    if (!far_with_modes)
    {
      RingCompliance::Far far;
      far.shapes = RingCompliance::far_shapes({&at_once, &of_modes});
      far.kernel = of_modes.between(far.shapes);
      const std::vector<FullMatrix<double>> at_same_sample = at_once.between(far.shapes);
      for (unsigned int tooth = 0; tooth < at_same_sample.size(); ++tooth)
        far.kernel[instants_between(tooth, 0)].add(1., at_same_sample[tooth]);
      far_with_modes = std::move(far);
    }
    return *far_with_modes;
  }

  void BlockCompliance::add_motions(const std::vector<PointVector> &force,
                                    std::vector<PointVector> &motion) const
  {
    const bool at_once_by_itself = whole.empty() || !at_once.applies_table();
    if (at_once_by_itself)
      add_motions_at_once(force, motion);
    if (instant.empty())
      return;
    const std::vector<PointVector> forces = by_instant(force);
    std::vector<PointVector> moved(motion.size());
    if (at_once_by_itself)
      of_modes.add_motions(&forces[0][0], &moved[0][0]);
    else
    {
      if (!product_with_whole)
        product_with_whole.emplace(transposed(whole));
      product_with_whole->add(&forces[0][0], &moved[0][0], 1);
    }
    moved = by_point(moved);
    for (std::size_t point = 0; point < motion.size(); ++point)
      motion[point] += moved[point];
  }

  void BlockCompliance::add_motions_at_once(const std::vector<PointVector> &force,
                                            std::vector<PointVector> &motion) const
  {
    at_once.add_motions(&force[0][0], &motion[0][0], n_samples);
  }

  void BlockCompliance::add_entries(const unsigned int moved, const unsigned int loaded,
                                    const std::vector<unsigned int> &rows,
                                    const std::vector<unsigned int> &columns, const double factor,
                                    const unsigned int first, FullMatrix<double> &matrix,
                                    const unsigned int row, const unsigned int column) const
  {
    if (!whole.empty())
    {
      add_selected(whole[instants_between(moved, loaded)], rows, columns, factor, first, matrix,
                   row, column);
      return;
    }
    if (sample(moved) == sample(loaded))
      at_once.add_entries(teeth_between(moved, loaded), rows, columns, factor, first, matrix, row,
                          column);
    if (!instant.empty())
      of_modes.add_entries(instants_between(moved, loaded), rows, columns, factor, first, matrix,
                           row, column);
  }

  const FullMatrix<double> *BlockCompliance::far_kernel(const unsigned int moved,
                                                        const unsigned int loaded) const
  {
    if (moved == loaded || part_of(moved) != part_of(loaded))
      return nullptr;
    return &far().kernel[instant.empty() ? teeth_between(moved, loaded)
                                         : instants_between(moved, loaded)];
  }

  std::vector<PointVector>
  BlockCompliance::by_instant(const std::vector<PointVector> &of_points) const
  {
    const unsigned int n_nodes = at_once.n_nodes();
    std::vector<PointVector> of_instants(of_points.size());
    for (unsigned int point = 0; point < of_points.size(); ++point)
      of_instants[instant[point / n_nodes] * n_nodes + point % n_nodes] = of_points[point];
    return of_instants;
  }

  std::vector<PointVector>
  BlockCompliance::by_point(const std::vector<PointVector> &of_instants) const
  {
    const unsigned int n_nodes = at_once.n_nodes();
    std::vector<PointVector> of_points(of_instants.size());
    for (unsigned int point = 0; point < of_points.size(); ++point)
      of_points[point] = of_instants[instant[point / n_nodes] * n_nodes + point % n_nodes];
    return of_points;
  }
} // namespace ringmotor
