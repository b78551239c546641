// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/algebra/circulant_product.h>
#include <ringmotor/contact/mortar.h>
#include <ringmotor/contact/surface_compliance.h>

#include <boost/serialization/vector.hpp>

#include <complex>
#include <functional>
#include <optional>
#include <vector>

namespace ringmotor
{
  /**
   * The compliance of all contact nodes of a ring of equal sectors: a matrix that depends only on
   * the distance d of two sectors,
   *
   *   near_d + basis K_d basis^T.
   *
   * Where on a sector a force acts matters only to the sector itself and its neighbours; for all
   * others a few far-reaching shapes suffice. So this takes far less memory than a table of all
   * entries, and far less work to apply: K by FFT over the sectors, near_d by matrix products.
   * Single entries are found faster in such a table, if it is small, and if it is smaller than K it
   * is applied as a whole by FFT.
   */
  class RingCompliance
  {
  public:
    /** Empty, to be assigned to. */
    RingCompliance() = default;

    /**
     * @param body the surface of a rotor
     * @param coupling the contact points of a sector; the surface's nodes may be of its neighbours
     * @param through_cut B_k for a nodal diameter 0 .. @p n_sectors / 2; not called if the body has
     * no shapes
     */
    RingCompliance(const unsigned int n_sectors, const SurfaceCompliance &body,
                   const MortarCoupling &coupling,
                   const std::function<dealii::FullMatrix<double>(unsigned int)> &through_cut);

    /**
     * A ring given by its waves: motions Re(u exp(2 pi i m j / n)) of sector j by forces Re(f exp(2
     * pi i m j / n)) are u = basis C_m basis^T f.
     * @param basis a row for each component of a node
     * @param waves C_m for m = 0 .. n / 2, by rows; of the first one, and of the last one where n
     * is even, only the real part counts
     */
    RingCompliance(const unsigned int n_sectors, const dealii::FullMatrix<double> &basis,
                   const std::vector<std::vector<std::complex<double>>> &waves);

    /** Adds a compliance within each sector, three components for each node. */
    void add_within_sectors(const dealii::FullMatrix<double> &compliance);

    /** C of a wave m = 0 .. n / 2 between all components of a sector's nodes, column by column:
     * motions Re(C f exp(2 pi i m j / n)) of sector j by forces Re(f exp(2 pi i m j / n)). */
    std::vector<std::complex<double>> of_wave(const unsigned int m) const;

    unsigned int n_sectors() const { return near.size(); }
    unsigned int n_nodes() const { return node_count; }

    /** A low-rank approximation of the coupling between sectors. */
    struct Far
    {
      dealii::FullMatrix<double> shapes; ///< by node and component, orthonormal columns
      std::vector<dealii::FullMatrix<double>> kernel; ///< by distance: motions by forces; 0 at 0
    };
    const Far &far() const;
    /** The shapes of Far for the sum of some compliances of the same sectors. */
    static dealii::FullMatrix<double> far_shapes(const std::vector<const RingCompliance *> &rings);
    /** Motions of given shapes due to forces on them, by distance. */
    std::vector<dealii::FullMatrix<double>> between(const dealii::FullMatrix<double> &shapes) const;

    /** Adds the motions (m) of all sectors under forces (N); both by ring, sector, node, component;
     * several equal rings together. */
    void add_motions(const double *forces, double *motions, const unsigned int n_rings = 1) const;

    /**
     * Adds the motions of nodes @p rows by unit forces on nodes @p columns of a sector that lies
     * @p distance sectors lower in theta, 0 .. n_sectors() - 1: @p factor times the three by three
     * entries for each pair go into @p matrix from @p row and @p column on, of rows only components
     * from @p first on.
     */
    void add_entries(const unsigned int distance, const std::vector<unsigned int> &rows,
                     const std::vector<unsigned int> &columns, const double factor,
                     const unsigned int first, dealii::FullMatrix<double> &matrix,
                     const unsigned int row, const unsigned int column) const;

    /** The same ring as one of n_sectors / @p fold sectors, for forces and motions that repeat with
     * that period. */
    RingCompliance folded(const unsigned int fold) const;

    /** All entries by distance. */
    std::vector<dealii::FullMatrix<double>> all_entries() const;
    /** Makes a table of all entries, from which add_entries() reads them. */
    void tabulate();
    bool has_table() const { return !table.empty(); }
    /** Whether a table is small enough to be made. */
    bool is_small() const;
    /** Whether the table is applied as a whole, which is faster where a sector has no more unknowns
     * than far-reaching shapes. */
    bool applies_table() const { return has_table() && 2 * node_count <= basis.n(); }

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      bool has_table = !table.empty(); // which is faster to recompute than to read
      archive &node_count &near &basis &kernel &has_table;
      if (Archive::is_loading::value)
      {
        table.clear();
        forget_what_follows();
        if (has_table)
          tabulate();
      }
    }

  private:
    /** The product with the kernel, or with the table, by FFT. */
    const CirculantProduct &ring_product() const;
    /** To be called when other members have changed. */
    void forget_what_follows();
    /** The motions of a sector due to forces on some other sectors that are not near. */
    dealii::FullMatrix<double> seen_from_afar() const;

    unsigned int node_count = 0;
    std::vector<dealii::FullMatrix<double>> near;   ///< by distance, transposed; empty if far
    dealii::FullMatrix<double> basis;               ///< a row for each component of a node
    std::vector<dealii::FullMatrix<double>> kernel; ///< by distance, transposed
    std::vector<dealii::FullMatrix<double>> table;  ///< by distance, of all entries; may be empty
    // What follows from these is computed when it is needed first.
    mutable std::optional<CirculantProduct> product_by_transform;
    mutable std::optional<Far> of_far;
  };

  /** Adds @p factor times the three by three entries for each pair of nodes @p rows and @p columns
   * from a matrix of all nodes, see RingCompliance::add_entries(). */
  void add_selected(const dealii::FullMatrix<double> &all, const std::vector<unsigned int> &rows,
                    const std::vector<unsigned int> &columns, const double factor,
                    const unsigned int first, dealii::FullMatrix<double> &matrix,
                    const unsigned int row, const unsigned int column);
} // namespace ringmotor
