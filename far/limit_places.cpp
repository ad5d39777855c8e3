// SPDX-License-Identifier: Apache-2.0
// Limit rows at places: grouped by element, made in parallel, put in the places' order.
#include <algorithm>
#include <atomic>
#include <numeric>
#include <optional>
#include <string>

#include <solidsubdiv/far/internal/limit_states.h>
#include <solidsubdiv/far/internal/scheme_check.h>
#include <solidsubdiv/far/internal/sharpness.h>
#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far {

namespace {

constexpr Offset kChunk = 256;  // places that a thread takes at a time

/// Rows made one after another: of each its weights in the point and in the derivatives, by vertex.
struct RowsOfChunk {
    std::vector<Index> indices;
    std::vector<double> weights;       ///< (number of indices, columns)
    std::vector<int> lengths, orders;  ///< of each row; order -1: no limit
};

/// States for pockets of every size: the smallest that knows a place does.
class LimitStatesBySize {
  public:
    static constexpr int kSizes = 4;

    LimitStatesBySize(const Sdc::Scheme& scheme, Elements elements) : least_(Internal::Reach::Of(scheme, elements)) {
        for (int i = 0; i < kSizes; ++i) {
            states_[static_cast<std::size_t>(i)] =
                std::make_unique<Internal::LimitStates>(scheme, elements, ReachOf(i));
        }
    }
    Internal::Reach ReachOf(int size) const {
        Internal::Reach reach = least_;
        reach.n_rings += size;
        return reach;
    }
    Internal::LimitStates& operator[](int size) { return *states_[static_cast<std::size_t>(size)]; }
    std::size_t n_states() const {
        std::size_t n = 0;
        for (const auto& states : states_) n += states->n_states();
        return n;
    }
    Offset Bytes() const {
        Offset bytes = 0;
        for (const auto& states : states_) bytes += states->Bytes();
        return bytes;
    }

  private:
    const Internal::Reach least_;
    std::array<std::unique_ptr<Internal::LimitStates>, kSizes> states_;
};

/// Makes the rows of places in one element after another. A thread needs its own.
class PlaceRowMaker {
  public:
    PlaceRowMaker(const TopologyRefiner& refiner, const Sharpness& sharpness, const LimitPlacesOptions& options,
                  LimitStatesBySize& states)
        : refiner_(refiner), sharpness_(sharpness), options_(options), states_(states) {}

    void Add(const Place& place, int n_columns, RowsOfChunk& rows) {
        if (place.element != element_) {
            element_ = place.element;
            for (Size& size : sizes_) size.state = nullptr;
        }
        int i = 0;
        for (; i < LimitStatesBySize::kSizes; ++i) {
            Evaluate(place, i);
            if (result_.outcome != Internal::LimitOutcome::Unknown) break;
        }
        const bool is_known = result_.outcome == Internal::LimitOutcome::Known;
        rows.orders.push_back(is_known ? result_.order : -1);
        const std::size_t before = rows.indices.size();
        if (is_known) Append(sizes_[static_cast<std::size_t>(i)].pocket, n_columns, rows);
        rows.lengths.push_back(static_cast<int>(rows.indices.size() - before));
    }

  private:
    struct Size {
        std::optional<Internal::PocketMaker> maker;
        Internal::Pocket pocket;
        Internal::LimitState* state = nullptr;
    };

    void Evaluate(const Place& place, int i) {
        Size& size = sizes_[static_cast<std::size_t>(i)];
        if (!size.state) {
            if (!size.maker) {
                const Internal::Reach reach = states_.ReachOf(i);
                if (refiner_.is_polyhedral()) {
                    size.maker.emplace(refiner_.polyhedral_level(options_.level), sharpness_, reach, options_.elements);
                } else {
                    size.maker.emplace(refiner_.level(options_.level), sharpness_, reach, options_.elements);
                }
            }
            size.pocket = size.maker->Make(element_);
            size.state = &states_[i].Find(size.pocket);
        }
        states_[i].Evaluate(*size.state, place, options_.order, options_.tangents, scratch_, result_);
    }

    void Append(const Internal::Pocket& pocket, int n_columns, RowsOfChunk& rows) const {
        const Internal::LimitBlock& block = result_.block;
        const std::size_t columns = static_cast<std::size_t>(block.n_columns);
        for (Index v = 0; v < pocket.n_vertices(); ++v) {
            const double* row = block.Row(v);
            if (std::all_of(row, row + columns, [](double w) { return w == 0; })) continue;
            rows.indices.push_back(pocket.vertices[static_cast<std::size_t>(v)]);
            rows.weights.insert(rows.weights.end(), row, row + columns);
            rows.weights.resize(rows.indices.size() * static_cast<std::size_t>(n_columns));
        }
    }

    const TopologyRefiner& refiner_;
    const Sharpness& sharpness_;
    const LimitPlacesOptions& options_;
    LimitStatesBySize& states_;
    Index element_ = kNoIndex;
    std::array<Size, LimitStatesBySize::kSizes> sizes_;
    Internal::LimitStates::Scratch scratch_;
    Internal::LimitResult result_;
};

}  // namespace

void LimitPlacesOptions::Validate() const {
    if (order < 0 || order > 2) {
        throw InvalidInput("order of derivatives is " + std::to_string(order) + "; it must be 0, 1 or 2");
    }
}

struct LimitStencilTableFactory::State {
    const TopologyRefiner& refiner;
    const Sdc::Scheme scheme;
    const LimitPlacesOptions options;
    const Sharpness sharpness;  // of the level
    std::optional<LimitStatesBySize> states;
    std::vector<PlaceRowMaker> makers;  // one a thread

    void Forget() {
        makers.clear();
        states.emplace(scheme, options.elements);
    }
    /// Makes rows [first, end) of the places in the order given, chunk by chunk.
    void Make(std::span<const Place> places, std::span<const Offset> order, Offset first_chunk, Offset end_chunk,
              int n_columns, std::vector<RowsOfChunk>& chunks) {
        const Offset n_threads = Sdc::ThreadCount();
        while (static_cast<Offset>(makers.size()) < n_threads)
            makers.emplace_back(refiner, sharpness, options, *states);
        std::atomic<Offset> next_chunk{first_chunk};
        Sdc::ParallelFor(n_threads, 1, [&](Offset begin, Offset end) {
            for (Offset thread = begin; thread < end; ++thread) {
                for (Offset c = next_chunk++; c < end_chunk; c = next_chunk++) {
                    const std::size_t from = static_cast<std::size_t>(c) * kChunk;
                    for (std::size_t i = from; i < std::min(order.size(), from + kChunk); ++i) {
                        makers[static_cast<std::size_t>(thread)].Add(places[static_cast<std::size_t>(order[i])],
                                                                     n_columns, chunks[static_cast<std::size_t>(c)]);
                    }
                }
            }
        });
    }
};

LimitStencilTableFactory::LimitStencilTableFactory(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                                   const LimitPlacesOptions& options) {
    options.Validate();
    Internal::CheckScheme(refiner, scheme);
    CheckPlaces(refiner, options.level, {}, options.elements);
    if (!refiner.is_full(options.level)) {
        throw InvalidInput("limits in level " + std::to_string(options.level) +
                           " need its full topology: refine with full_topology_in_last_level");
    }
    state_.reset(new State{
        refiner, scheme, options, Internal::SharpnessOfLevels(refiner, scheme, options.level + 1).back(), {}, {}});
    state_->Forget();
}

LimitStencilTableFactory::~LimitStencilTableFactory() = default;
LimitStencilTableFactory::LimitStencilTableFactory(LimitStencilTableFactory&&) noexcept = default;
LimitStencilTableFactory& LimitStencilTableFactory::operator=(LimitStencilTableFactory&&) noexcept = default;

std::size_t LimitStencilTableFactory::n_neighborhoods() const { return state_->states->n_states(); }
Offset LimitStencilTableFactory::Bytes() const { return state_->states->Bytes(); }

LimitStencilTable LimitStencilTable::Create(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                            std::span<const Place> places, const LimitPlacesOptions& options) {
    return LimitStencilTableFactory(refiner, scheme, options).Create(places);
}

LimitStencilTable LimitStencilTableFactory::Create(std::span<const Place> places) {
    const TopologyRefiner& refiner = state_->refiner;
    const LimitPlacesOptions& options = state_->options;
    CheckPlaces(refiner, options.level, places, options.elements);

    // Places in one element follow each other.
    const Offset n = static_cast<Offset>(places.size());
    std::vector<Offset> order(places.size());
    std::iota(order.begin(), order.end(), Offset{0});
    std::stable_sort(order.begin(), order.end(), [&](Offset a, Offset b) {
        return places[static_cast<std::size_t>(a)].element < places[static_cast<std::size_t>(b)].element;
    });
    const Offset n_chunks = (n + kChunk - 1) / kChunk;
    const int n_columns = 1 + Internal::NDerivatives(options.elements, options.order);
    std::vector<RowsOfChunk> chunks(static_cast<std::size_t>(n_chunks));
    constexpr Offset kMostBytes = Offset{1} << 30;  // of states that are kept: then they are found anew
    const Offset wave = 16 * Sdc::ThreadCount();
    for (Offset first = 0; first < n_chunks; first += wave) {
        Report(options.progress, "limit rows", static_cast<double>(first) / static_cast<double>(n_chunks));
        if (Bytes() > kMostBytes) state_->Forget();
        state_->Make(places, order, first, std::min(n_chunks, first + wave), n_columns, chunks);
    }
    Report(options.progress, "limit rows", 1.0);

    LimitStencilTable table;
    table.rows_.n_sources = refiner.n_vertices(options.level);
    table.rows_.offsets.assign(places.size() + 1, 0);
    std::vector<int> orders(places.size());
    for (Offset i = 0; i < n; ++i) {
        const RowsOfChunk& chunk = chunks[static_cast<std::size_t>(i / kChunk)];
        const Offset place = order[static_cast<std::size_t>(i)];
        table.rows_.offsets[place + 1] = chunk.lengths[static_cast<std::size_t>(i % kChunk)];
        orders[static_cast<std::size_t>(place)] = chunk.orders[static_cast<std::size_t>(i % kChunk)];
    }
    for (Offset i = 0; i < n; ++i) table.rows_.offsets[i + 1] += table.rows_.offsets[i];
    const std::size_t n_weights = static_cast<std::size_t>(table.rows_.offsets.back());
    table.rows_.indices.resize(n_weights);
    table.rows_.weights.resize(n_weights);
    table.derivatives_.resize(static_cast<std::size_t>(n_columns - 1));
    for (Array<double>& weights : table.derivatives_) weights.resize(n_weights);
    Sdc::ParallelFor(n_chunks, 1, [&](Offset begin, Offset end) {
        for (Offset c = begin; c < end; ++c) {
            RowsOfChunk& chunk = chunks[static_cast<std::size_t>(c)];
            std::size_t from = 0;
            for (std::size_t r = 0; r < chunk.lengths.size(); ++r) {
                Offset to = table.rows_.offsets[order[static_cast<std::size_t>(c * kChunk) + r]];
                for (int k = 0; k < chunk.lengths[r]; ++k, ++from, ++to) {
                    table.rows_.indices[to] = chunk.indices[from];
                    const double* weights = chunk.weights.data() + from * static_cast<std::size_t>(n_columns);
                    table.rows_.weights[to] = weights[0];
                    for (int column = 1; column < n_columns; ++column) {
                        table.derivatives_[static_cast<std::size_t>(column - 1)][to] = weights[column];
                    }
                }
            }
            chunk = {};
        }
    });
    for (std::size_t i = 0; i < orders.size(); ++i) {
        if (orders[i] >= options.order) continue;
        const std::string name = "place " + std::to_string(i);
        if (orders[i] < 0) {
            table.without_limit_.push_back(static_cast<Index>(i));
            table.defects_.push_back({DefectCode::NoLimit, static_cast<Index>(i), 0, name + " has no limit"});
        } else {
            table.defects_.push_back({DefectCode::NoDerivative, static_cast<Index>(i), orders[i] + 1.0,
                                      name + (orders[i] == 0 ? " has no derivatives" : " has no second derivatives")});
        }
    }
    return table;
}

StencilRows<double> LimitStencilTable::DerivativeRows(int k) const {
    StencilRows<double> rows = rows_;
    rows.weights = derivatives_[static_cast<std::size_t>(k)];
    return rows;
}

Offset LimitStencilTable::Bytes() const {
    Offset bytes = rows_.Bytes();
    for (const Array<double>& weights : derivatives_) bytes += static_cast<Offset>(weights.size() * sizeof(double));
    return bytes;
}

}  // namespace SolidSubdiv::Far
