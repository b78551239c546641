# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts start from: their surroundings, the programs, and what users type."""
