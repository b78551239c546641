// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_surface.h>

#include <vector>

namespace ringmotor
{
  /**
   * The coupling of the surfaces of tooth and rotor, whose meshes do not match. Tractions are
   * expanded in dual functions psi of the tooth's surface: the integral of psi_a times a shape
   * function of the tooth is zero except for that of the same node, for which it is the node's area
   * (Wohlmuth 2000; Popp et al. 2012 for quadratic faces). Force F_a of a node is its area times
   * the traction there; it acts on the tooth at the node alone, and on the rotor at the nodes and
   * with the weights given here. The same weights give the mean displacement of the rotor that is
   * compared with the tooth's.
   */
  struct MortarCoupling
  {
    /** The weight of a rotor node in the mean displacement at a tooth node; those of one tooth node
     * add up to 1. */
    struct Weight
    {
      unsigned int rotor_node;
      int sector; ///< of the rotor node: 0 is that of the tooth, 1 the next one in theta
      double weight;
    };
    struct Node
    {
      unsigned int tooth_node;
      double area; ///< m^2, integral of psi
      std::vector<Weight> weights;
    };
    std::vector<Node> nodes; ///< nodes of the tooth that the rotor's surface covers
  };

  /**
   * Integrates over the segments that two faces have in common, in the plane (r, theta). Faces of
   * the tooth may be partly covered: the functions are then those of the covered part. (The covered
   * part of a quadratic face must be large enough for the integrals of all shape functions to be
   * positive.) @p pitch (rad) is the angle from sector to sector; the rotor's surface is turned by
   * @p shift (rad).
   *
   * Faces are straight in that plane, while the parametrisation of a body's quadratic arcs is not
   * quite uniform: for half an arc a (rad) a constant pressure is reproduced with an error of some
   * 0.1 a^2.
   *
   * @throws UserError if too little of a quadratic face is covered
   */
  MortarCoupling couple(const ContactSurface &tooth, const ContactSurface &rotor,
                        const double pitch, const double shift = 0.);
} // namespace ringmotor
