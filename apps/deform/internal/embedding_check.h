// SPDX-License-Identifier: Apache-2.0
// Whether tables that were read are tables of an embedding: nothing that uses them may read out of bounds.
#pragma once

#include <solidsubdiv/apps/deform/embedding.h>

namespace SolidSubdiv::Deform::Internal {

/// @throws InvalidInput naming what is wrong
void CheckTables(const EmbeddingTables& tables);

}  // namespace SolidSubdiv::Deform::Internal
