# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the programs left in the folder of a case: reads it, and tells it on a page."""
