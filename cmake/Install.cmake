# SPDX-License-Identifier: Apache-2.0
# Installs every room: its headers, its library in the export set, and the package that find_package(SolidSubdiv) reads.
