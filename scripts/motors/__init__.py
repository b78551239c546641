# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many motors: how they vary, are computed, chosen, fitted, and written down."""
