# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a case, and the scenes of ParaView."""
