// SPDX-License-Identifier: Apache-2.0
// The least a downstream program does: one header, one call, and a status that says whether the answer was right.
#include <solidsubdiv/sdc/parallel.h>

#include <cstdio>
#include <vector>

int main() {
    using namespace SolidSubdiv;
    std::vector<Offset> offsets(1001, 3);
    const Offset total = Sdc::ScanLengths(offsets);
    std::printf("rows of 3: %lld in all, on %d threads\n", static_cast<long long>(total), Sdc::ThreadCount());
    return total == 3000 && offsets[999] == 2997 ? 0 : 1;
}
