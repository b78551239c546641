// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/shared_work.h>
#include <ringmotor/wave/shared_modes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Numbers by nodal diameter, a vector for each of its items. */
    using Packed = std::map<unsigned int, std::vector<std::vector<double>>>;

    Packed merged(const Packed &mine, MPI_Comm ranks)
    {
      Packed all;
      for (const Packed &of_rank : of_all_ranks(mine, ranks))
        all.insert(of_rank.begin(), of_rank.end());
      return all;
    }

    std::vector<double> packed(const Mode &mode)
    {
      std::vector<double> numbers{mode.eigenvalue, mode.rigid ? 1. : 0., mode.algebra_error};
      for (const ComplexField *part : mode.motion.parts())
        for (const Vector<double> *field : {&part->real, &part->imaginary})
          numbers.insert(numbers.end(), field->begin(), field->end());
      return numbers;
    }

    Mode unpacked(const unsigned int k, const std::vector<double> &numbers,
                  const CyclicSector &sector)
    {
      Mode mode{k, numbers[0], numbers[1] != 0., sector.at_rest(), numbers[2]};
      auto next = numbers.begin() + 3;
      for (ComplexField *part : mode.motion.parts())
        for (Vector<double> *field : {&part->real, &part->imaginary})
        {
          std::copy_n(next, field->size(), field->begin());
          next += field->size();
        }
      return mode;
    }
  } // namespace

  std::vector<unsigned int> share_of_rank(const std::vector<unsigned int> &nodal_diameters,
                                          MPI_Comm ranks)
  {
    std::vector<unsigned int> share;
    for (std::size_t i = 0; i < nodal_diameters.size(); ++i)
      if (is_my_turn(i, ranks))
        share.push_back(nodal_diameters[i]);
    return share;
  }

  std::map<unsigned int, std::vector<ShiftWindow>>
  gathered(const std::map<unsigned int, std::vector<ShiftWindow>> &mine, MPI_Comm ranks)
  {
    Packed packed_windows;
    for (const auto &[k, windows] : mine)
      for (const ShiftWindow &window : windows)
        packed_windows[k].push_back({window.low, window.high});
    std::map<unsigned int, std::vector<ShiftWindow>> all;
    for (const auto &[k, windows] : merged(packed_windows, ranks))
      for (const std::vector<double> &window : windows)
        all[k].push_back({window[0], window[1]});
    return all;
  }

  std::map<unsigned int, std::vector<Mode>>
  gathered(const std::map<unsigned int, std::vector<Mode>> &mine, const CyclicSector &sector,
           MPI_Comm ranks)
  {
    if (Utilities::MPI::n_mpi_processes(ranks) == 1)
      return mine;
    Packed packed_modes;
    for (const auto &[k, modes] : mine)
      for (const Mode &mode : modes)
        packed_modes[k].push_back(packed(mode));
    std::map<unsigned int, std::vector<Mode>> all;
    for (const auto &[k, modes] : merged(packed_modes, ranks))
      for (const std::vector<double> &numbers : modes)
        all[k].push_back(unpacked(k, numbers, sector));
    return all;
  }
} // namespace ringmotor
