// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/contact_certificate.h>
#include <ringmotor/contact/solve/row_solver.h>

#include <vector>

namespace ringmotor
{
  /** Constants that turn the complementarity conditions into equations; N/m. */
  struct ComplementarityConstants
  {
    double normal;     ///< about 1 / normal compliance of a contact node
    double tangential; ///< about 1 / largest eigenvalue of the tangential compliance of a tooth
  };

  /**
   * The linear system of one step of the semi-smooth Newton method (primal-dual active set) for
   * contact with friction: p = max(0, p - c_n gap), and for a touching node either slip = 0 or
   * F_t = bound tau/|tau|, tau = F_t - c_t slip. (Alart and Curnier 1991; Hueeber, Stadler and
   * Wohlmuth 2008.) Unknowns are the changes of the forces at the touching nodes and of the rigid
   * motions.
   */
  class NewtonSystem
  {
  public:
    /** Chooses open, sticking and slipping nodes, by the forces and by the motion @p seen, which
     * may be @p motion. Open nodes lose their forces: @p state and @p motion, its relative motion,
     * are changed. */
    NewtonSystem(const ContactProblem &problem, const FrictionBoundOf &bound_of,
                 const ComplementarityConstants &constants, const std::vector<PointVector> &seen,
                 ContactState &state, std::vector<PointVector> &motion);

    /** Adds the solution to the state. @p reduction is that of the residual by a Krylov method.
     * @return false if the system is singular, or the Krylov method does not converge */
    bool solve(RowSolver &solver, const double reduction, ContactState &state) const;

    unsigned int n_touching() const { return touching.size(); }

  private:
    struct Choice;
    Choice choice_of(const PointVector &force, const PointVector &motion,
                     const FrictionBound &bound) const;
    void add_slip(ContactRow &row, const Choice &choice, const PointVector &force,
                  const PointVector &motion, const FrictionBound &bound) const;

    const ContactProblem &problem;
    const ComplementarityConstants constants;
    std::vector<unsigned int> touching;
    std::vector<ContactRow> rows; ///< of the touching nodes
    std::vector<double> balances;
  };
} // namespace ringmotor
