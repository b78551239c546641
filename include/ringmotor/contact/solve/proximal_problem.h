// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/contact_problem.h>

namespace ringmotor
{
  /**
   * A contact problem with springs that pull its solution towards a given state: at each contact
   * node a compliance, on which only the change of the force from that state acts, and for each
   * rigid motion a stiffness against its change. One step of the proximal point algorithm
   * (Rockafellar 1976; in the rigid motions it is the proximal method of multipliers). With strong
   * springs the solution is near the given state and easy to find; with none it is that of the
   * problem itself.
   */
  class ProximalProblem : public ContactProblem
  {
  public:
    /** The springs. */
    struct Springs
    {
      double normal, tangential;           ///< m/N
      std::vector<double> rigid_stiffness; ///< change of a balance per change of its rigid motion
    };

    /** All must outlive this object. */
    ProximalProblem(const ContactProblem &problem, const ContactState &centre,
                    const Springs &springs);

    unsigned int n_points() const override { return problem.n_points(); }
    unsigned int n_rigid() const override { return problem.n_rigid(); }
    std::vector<PointVector> relative_motion(const ContactState &state) const override;
    std::vector<PointVector> motion_by(const ContactState &change) const override;
    void derivatives(const std::vector<unsigned int> &rows,
                     const std::vector<unsigned int> &columns,
                     dealii::FullMatrix<double> &matrix) const override;
    const BlockStructure &structure() const override { return problem.structure(); }
    std::vector<double> balances(const ContactState &state) const override;
    void balance_derivatives(const std::vector<unsigned int> &points,
                             dealii::FullMatrix<double> &matrix) const override;

  private:
    double spring(const unsigned int component) const
    {
      return component == 0 ? springs.normal : springs.tangential;
    }

    const ContactProblem &problem;
    const ContactState &centre;
    const Springs &springs;
  };
} // namespace ringmotor
