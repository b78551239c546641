// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/contact_bodies.h>
#include <ringmotor/pictures/surface_trace.h>

namespace ringmotor
{
  /** The motion (m; r, theta, z components) of a surface between the points of a trace of at least
   * one face, interpolated in the plane (r, theta) by the polynomials that they determine. Next to
   * the surface that of the nearest face continues. */
  WaveMotion motion_of(SurfaceTrace trace);
} // namespace ringmotor
