// SPDX-License-Identifier: Apache-2.0
// Volumes of every format: the same values, voxels where the standards say they are, and what is refused.
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include <solidsubdiv/kit/io/internal/voxel_data.h>
#include <solidsubdiv/kit/io/volumes.h>

#include "kit/io/damage.h"

namespace SolidSubdiv::Io {
namespace {

using Geometry::AffineMap;
using Geometry::Volume;

/// The corpus's values (io_corpus/make_points_and_volumes.py): i + 10 j + 100 k in 4 x 3 x 2.
std::vector<double> CorpusValues() {
    std::vector<double> values;
    for (int n = 0; n < 24; ++n) values.push_back(n % 4 + 10 * (n / 4 % 3) + 100 * (n / 12));
    return values;
}

constexpr AffineMap kSteps = {2, 0, 0, 10, 0, 3, 0, 20, 0, 0, 4, 30};
/// The first axis along +y, the second along -x.
constexpr AffineMap kTurned = {0, -3, 0, 10, 2, 0, 0, 20, 0, 0, 4, 30};

TEST(Volumes, EveryEncodingGivesTheSameValuesAndPlaces) {
    const std::map<std::string, AffineMap> files = {{"volume_raw.nrrd", kTurned},  {"volume_gzip.nrrd", kTurned},
                                                    {"volume_text.nrrd", kSteps},  {"volume_detached.nhdr", kSteps},
                                                    {"volume_local.mha", kTurned}, {"volume_zlib.mha", kSteps},
                                                    {"volume_text.mhd", kSteps}};
    for (const auto& [name, map] : files) {
        const Volume volume = ReadVolume(Corpus(name));
        EXPECT_EQ(volume.dims, (std::array<Offset, 3>{4, 3, 2})) << name;
        EXPECT_EQ(volume.values, CorpusValues()) << name;
        EXPECT_EQ(volume.voxel_to_world, map) << name;
        EXPECT_THAT(volume.notes, testing::IsEmpty()) << name;
    }
}

TEST(Nifti, QFormTurnsByItsQuaternion) {
    const Volume volume = ReadVolume(Corpus("volume_qform.nii"));
    EXPECT_EQ(volume.values, CorpusValues());
    // By hand from the standard, method 2: a = sqrt(1 - 3/4) = 1/2, so that R = (0 0 1; 1 0 0; 0 1 0), a third of a
    // turn about (1, 1, 1); sizes 2, 3, 4, the third column negative by qfac = -1; offset (10, 20, 30).
    EXPECT_EQ(volume.voxel_to_world, (AffineMap{0, 0, -4, 10, 2, 0, 0, 20, 0, 3, 0, 30}));
    EXPECT_EQ(volume.ToWorld({1, 2, 1}), (std::array<double, 3>{6, 22, 36}));
}

TEST(Nifti, SFormGoesFirstAndValuesAreScaled) {
    const Volume volume = ReadVolume(Corpus("volume_sform_big.nii.gz"));
    EXPECT_EQ(volume.voxel_to_world, (AffineMap{2, .5, 0, -10, 0, 3, 0, -20, 0, 0, 4, -30}));
    std::vector<double> expected = CorpusValues();
    for (double& x : expected) x = 2 * x - 5;
    EXPECT_EQ(volume.values, expected);
    // Its corner by hand: 2 * 3 + .5 * 2 - 10, 3 * 2 - 20, 4 - 30.
    EXPECT_EQ(volume.ToWorld({3, 2, 1}), (std::array<double, 3>{-3, -14, -26}));
}

TEST(Nifti, EitherFileOfAPairIsReadAndPlacesAreSizesWithoutForms) {
    for (const char* name : {"volume_pair.hdr", "volume_pair.img"}) {
        const Volume volume = ReadVolume(Corpus(name));
        EXPECT_EQ(volume.values, CorpusValues());
        EXPECT_EQ(volume.voxel_to_world, (AffineMap{1, 0, 0, 0, 0, .5, 0, 0, 0, 0, .25, 0}));
        EXPECT_THAT(volume.notes, testing::ElementsAre(testing::HasSubstr("neither sform nor qform")));
    }
}

// ---- Every type of number, in both byte orders ----

template <class T>
std::string BytesOf(T number, bool big) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &number, sizeof(T));
    if (big != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

/// A header of NIfTI with 2 x 1 x 1 voxels, and its numbers.
struct NiftiFile {
    bool big = false;
    std::string bytes = std::string(352, '\0');

    template <class T>
    NiftiFile& Put(std::size_t at, T number) {
        bytes.replace(at, sizeof(T), BytesOf(number, big));
        return *this;
    }
    NiftiFile& Start(std::int16_t type) {
        bytes.replace(344, 4, std::string("n+1\0", 4));
        Put<std::int32_t>(0, 348).Put<std::int16_t>(40, 3).Put<std::int16_t>(42, 2).Put<std::int16_t>(44, 1);
        for (std::size_t k = 1; k < 4; ++k) Put<float>(76 + 4 * k, 1);
        return Put<std::int16_t>(46, 1).Put<std::int16_t>(70, type).Put<float>(108, 352);
    }
};

template <class T>
void ExpectNumbers(std::int16_t nifti, const std::string& nrrd, const std::string& meta) {
    const T low = std::numeric_limits<T>::lowest(), high = std::numeric_limits<T>::max();
    // 64-bit integers only as far as doubles hold them.
    const T a =
        sizeof(T) == 8 && std::is_integral_v<T> ? static_cast<T>(std::is_signed_v<T> ? -9007199254740991 : 0) : low;
    const T b = sizeof(T) == 8 && std::is_integral_v<T> ? static_cast<T>(9007199254740991) : high;
    TemporaryFolder folder;
    for (const bool big : {false, true}) {
        const std::string numbers = BytesOf(a, big) + BytesOf(b, big);
        NiftiFile file;
        file.big = big;
        Save(folder / "a.nii", file.Start(nifti).bytes + numbers);
        Save(folder / "a.nrrd", "NRRD0001\ntype: " + nrrd + "\ndimension: 3\nsizes: 2 1 1\nendian: " +
                                    (big ? "big" : "little") + "\nencoding: raw\n\n" + numbers);
        Save(folder / "a.mha", "NDims = 3\nDimSize = 2 1 1\nElementType = " + meta + "\nElementByteOrderMSB = " +
                                   (big ? "True" : "False") + "\nElementDataFile = LOCAL\n" + numbers);
        for (const char* name : {"a.nii", "a.nrrd", "a.mha"}) {
            EXPECT_THAT(ReadVolume(folder / name).values,
                        testing::ElementsAre(static_cast<double>(a), static_cast<double>(b)))
                << name << nrrd << big;
        }
    }
}

TEST(Volumes, EveryTypeOfNumberIsReadInBothByteOrders) {
    ExpectNumbers<std::uint8_t>(2, "uchar", "MET_UCHAR");
    ExpectNumbers<std::int16_t>(4, "short", "MET_SHORT");
    ExpectNumbers<std::int32_t>(8, "int", "MET_INT");
    ExpectNumbers<float>(16, "float", "MET_FLOAT");
    ExpectNumbers<double>(64, "double", "MET_DOUBLE");
    ExpectNumbers<std::int8_t>(256, "signed char", "MET_CHAR");
    ExpectNumbers<std::uint16_t>(512, "unsigned short", "MET_USHORT");
    ExpectNumbers<std::uint32_t>(768, "uint32_t", "MET_ULONG");
    ExpectNumbers<std::int64_t>(1024, "long long", "MET_LONG_LONG");
    ExpectNumbers<std::uint64_t>(1280, "uint64", "MET_ULONG_LONG");
}

TEST(Volumes, IntegersThatADoubleCannotHoldAreRefused) {
    TemporaryFolder folder;
    NiftiFile file;
    Save(folder / "a.nii",
         file.Start(1024).bytes + BytesOf<std::int64_t>(1, false) + BytesOf<std::int64_t>(9007199254740992, false));
    EXPECT_THAT(ErrorOf([&] { ReadVolume(folder / "a.nii"); }),
                testing::HasSubstr("voxel (1, 0, 0) is an integer beyond 2^53"));
}

TEST(Nifti, AHalfTurnWhoseQuaternionIsRoundedIsOne) {
    TemporaryFolder folder;
    NiftiFile file;
    file.Start(2).Put<std::int16_t>(252, 1).Put<float>(256, 1.0000001f);
    Save(folder / "a.nii", file.bytes + "ab");
    // About the first axis: the other two turn round.
    EXPECT_EQ(ReadVolume(folder / "a.nii").voxel_to_world, (AffineMap{1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0}));
}

// ---- What is refused ----

struct BadFile {
    std::string name;
    std::string bytes;
    std::string says;
};

std::string Nifti(const std::function<void(NiftiFile&)>& spoil, const std::string& numbers = "ab") {
    NiftiFile file;
    spoil(file.Start(2));
    return file.bytes + numbers;
}
std::string Nrrd(const std::string& fields, const std::string& numbers = "ab") {
    return "NRRD0004\n" + fields + "\n\n" + numbers;
}
const std::string kRaw = "type: uchar\nencoding: raw\n";
std::string Meta(const std::string& fields, const std::string& numbers = "ab") {
    return "NDims = 3\nDimSize = 2 1 1\n" + fields + "\nElementDataFile = LOCAL\n" + numbers;
}

const std::vector<BadFile> kBadVolumes = {
    {"unknown.raw", "x", "the extension '.raw' is unknown; known are .nii, .nii.gz"},

    {"short.nii", "hello", "is no NIfTI-1 file: it is shorter"},
    {"other.nii", std::string(400, 'a'), "is no NIfTI-1 file"},
    {"two.nii", Nifti([](NiftiFile& f) { f.Put<std::int32_t>(0, 540); }), "NIfTI-2"},
    {"analyze.hdr", Nifti([](NiftiFile& f) { f.Put<std::int32_t>(344, 0); }), "no mark of NIfTI-1"},
    {"dims.nii", Nifti([](NiftiFile& f) { f.Put<std::int16_t>(40, 8); }), "has 8 dimensions"},
    {"zero.nii", Nifti([](NiftiFile& f) { f.Put<std::int16_t>(44, 0); }), "has 0 voxels along axis 1"},
    {"series.nii", Nifti([](NiftiFile& f) { f.Put<std::int16_t>(40, 4).Put<std::int16_t>(48, 16); }),
     "holds 16 volumes; one is needed"},
    {"colours.nii", Nifti([](NiftiFile& f) { f.Put<std::int16_t>(70, 128); }), "numbers of NIfTI's type 128"},
    {"offset.nii", Nifti([](NiftiFile& f) { f.Put<float>(108, 1e30f); }), "vox_offset is no place"},
    {"flat.nii", Nifti([](NiftiFile& f) { f.Put<std::int16_t>(254, 1); }), "no volume in the world"},
    {"nanform.nii", Nifti([](NiftiFile& f) { f.Put<std::int16_t>(252, 1).Put<float>(256, std::nanf("")); }),
     "no volume in the world"},
    {"cut.nii", Nifti([](NiftiFile&) {}, "a"), "2 x 1 x 1 voxels take 2 bytes, but only 1 byte are there"},
    {"large.nii", Nifti([](NiftiFile& f) {
         f.Put<std::int16_t>(42, 32767).Put<std::int16_t>(44, 32767).Put<std::int16_t>(46, 32767);
     }),
     "32767 x 32767 x 32767 voxels take 35181150961663 bytes, but only 2 bytes"},
    {"cut.nii.gz", std::string("\x1f\x8b\x08\0\0\0\0\0\0\3", 10), "in its compressed data"},
    {"nan.nii", Nifti([](NiftiFile& f) { f.Put<std::int16_t>(70, 16); }, std::string(4, '\0') + "\xff\xff\xff\xff"),
     "voxel (1, 0, 0) is not a finite number"},
    {"alone.hdr", Nifti([](NiftiFile& f) { f.bytes[345] = 'i'; }).replace(344, 4, std::string("ni1\0", 4)),
     "alone.img: there is no such file"},

    {"start.nrrd", "hello", "is no NRRD file"},
    {"line.nrrd", Nrrd("type float"), "the line 'type float' of its header is no field"},
    {"sizes.nrrd", Nrrd("type: uchar"), "the header has no field 'sizes'"},
    {"axes.nrrd", Nrrd(kRaw + "dimension: 3\nsizes: 2 1"), "2 sizes for 3 dimensions"},
    {"plane.nrrd", Nrrd(kRaw + "dimension: 2\nsizes: 2 1"), "has 2 dimensions; a volume has 3"},
    {"type.nrrd", Nrrd("type: block\nencoding: raw\ndimension: 3\nsizes: 2 1 1"), "'block' can't be read"},
    {"bzip.nrrd", Nrrd("type: uchar\nencoding: bzip2\ndimension: 3\nsizes: 2 1 1"), "'bzip2' can't be read"},
    {"endian.nrrd", Nrrd("type: short\nencoding: raw\ndimension: 3\nsizes: 1 1 1"), "no field 'endian'"},
    {"vector.nrrd", Nrrd(kRaw + "dimension: 4\nsizes: 3 2 1 1\nkinds: vector domain domain domain"),
     "axis 0 holds 3 values for each voxel"},
    {"time.nrrd", Nrrd(kRaw + "dimension: 4\nsizes: 2 1 1 9"), "axis 3 holds 9 values"},
    {"direction.nrrd", Nrrd(kRaw + "dimension: 3\nsizes: 2 1 1\nspace directions: (1,0,0) (0,1) (0,0,1)"),
     "the field space directions: expected three coordinates"},
    {"parallel.nrrd", Nrrd(kRaw + "dimension: 3\nsizes: 2 1 1\nspace directions: (1,0,0) (0,1,0) (1,1,0)"),
     "no volume in the world"},
    {"many.nrrd", Nrrd(kRaw + "dimension: 3\nsizes: 4000000000 4000000000 4000000000"), "more voxels than can be"},
    {"cut.nrrd", Nrrd(kRaw + "dimension: 3\nsizes: 2 2 1"), "take 4 bytes, but only 2 bytes are there"},
    {"skip.nrrd", Nrrd(kRaw + "dimension: 3\nsizes: 2 1 1\nbyte skip: 1"), "but only 1 byte are there"},
    {"gzip.nrrd", Nrrd("type: uchar\nencoding: gzip\ndimension: 3\nsizes: 2 1 1"), "compressed data"},
    {"text.nrrd", Nrrd("type: uchar\nencoding: text\ndimension: 3\nsizes: 2 1 1", "1 b"),
     "expected a value, found 'b'"},
    {"list.nhdr", Nrrd(kRaw + "dimension: 3\nsizes: 2 1 1\ndata file: LIST"), "in several files"},
    {"gone.nhdr", Nrrd(kRaw + "dimension: 3\nsizes: 2 1 1\ndata file: gone.raw"), "gone.raw: there is no such file"},

    {"start.mha", "hello", "is none of a MetaImage header"},
    {"end.mha", "NDims = 3\n", "no ElementDataFile"},
    {"ndims.mha", "NDims = 2\nDimSize = 2 1\nElementDataFile = LOCAL\n", "2 dimensions; a volume has 3"},
    {"channels.mha", Meta("ElementType = MET_UCHAR\nElementNumberOfChannels = 3"), "one number a voxel"},
    {"type.mha", Meta("ElementType = MET_STRING"), "'MET_STRING' can't be read"},
    {"spacing.mha", Meta("ElementType = MET_UCHAR\nElementSpacing = 1 0 1"), "no volume in the world"},
    {"numbers.mha", Meta("ElementType = MET_UCHAR\nOffset = 1 0"), "3 numbers are needed, 2 are there"},
    {"cut.mha", Meta("ElementType = MET_SHORT"), "take 4 bytes, but only 2 bytes"},
    {"zlib.mha", Meta("ElementType = MET_SHORT\nCompressedData = True"), "its compressed data are damaged"},
    {"list.mhd", "NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\nElementDataFile = %03d.raw 1 2 1\n",
     "in one file"},
};

class BadVolumes : public testing::TestWithParam<BadFile> {};

TEST_P(BadVolumes, FileGivesOneLineThatNamesIt) {
    TemporaryFolder folder;
    const auto path = folder / GetParam().name;
    Save(path, GetParam().bytes);
    const std::string message = ErrorOf([&] { ReadVolume(path); });
    EXPECT_THAT(message, testing::StartsWith((folder / "").string()));
    EXPECT_THAT(message, testing::HasSubstr(GetParam().says));
    EXPECT_EQ(message.find('\n'), message.npos);
}

INSTANTIATE_TEST_SUITE_P(Files, BadVolumes, testing::ValuesIn(kBadVolumes),
                         [](const auto& bad) { return TestNameOf(bad.param.name); });

TEST(Volumes, AWrongChecksumOfCompressedDataIsSeen) {
    std::string bytes = Load(Corpus("volume_gzip.nrrd"));
    TemporaryFolder folder;
    Save(folder / "a.nrrd", bytes);
    EXPECT_EQ(ErrorOf([&] { ReadVolume(folder / "a.nrrd"); }), "");
    bytes[bytes.size() - 6] ^= 1;
    Save(folder / "a.nrrd", bytes);
    EXPECT_THAT(ErrorOf([&] { ReadVolume(folder / "a.nrrd"); }), testing::HasSubstr("damaged"));
}

// ---- Damage ----

void ExpectConsistent(const Volume& volume) {
    ASSERT_GT(volume.n_voxels(), 0);
    ASSERT_EQ(volume.values.size(), static_cast<std::size_t>(volume.n_voxels()));
    ASSERT_TRUE(std::all_of(volume.values.begin(), volume.values.end(), [](double x) { return std::isfinite(x); }));
    ASSERT_NO_THROW(Geometry::Inverse(volume.voxel_to_world));
}

/// Of headers with their data elsewhere the header is damaged.
ReadDamaged VolumeReaderOf(const std::filesystem::path& path) {
    const std::string format(FindVolumeFormat(path)->name);
    const auto parse = format == "NIfTI"  ? Internal::ParseNifti
                       : format == "NRRD" ? Internal::ParseNrrd
                                          : Internal::ParseMetaImage;
    std::string beside;
    for (const char* extension : {".img", ".raw"}) {
        auto other = path;
        if (beside.empty()) beside = Load(other.replace_extension(extension));
    }
    return [parse, beside](const std::string& bytes) {
        bool is_beside = false;
        const auto read_beside = [&](const std::filesystem::path&) {
            is_beside = true;
            return beside;
        };
        try {
            ExpectConsistent(parse(bytes, "damaged", read_beside));
        } catch (const IoError& error) {
            // What is wrong with the numbers is told of the file that holds them.
            const std::string message = error.what();
            throw IoError((is_beside && message.rfind("damaged: ", 0) != 0 ? "damaged: " : "") + message);
        }
    };
}

bool HoldsAVolume(const std::filesystem::path& path) {
    return path.extension() != ".img" && FindVolumeFormat(path) != nullptr;
}

class DamagedVolumes : public testing::TestWithParam<std::string> {};

TEST_P(DamagedVolumes, TruncatedAnywhere) {
    TruncateAnywhere(VolumeReaderOf(Corpus(GetParam())), Load(Corpus(GetParam())));
}

TEST_P(DamagedVolumes, ChangedAnywhere) {
    ChangeAnywhere(VolumeReaderOf(Corpus(GetParam())), Load(Corpus(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Corpus, DamagedVolumes, testing::ValuesIn(CorpusFiles(HoldsAVolume)),
                         [](const auto& file) { return TestNameOf(file.param); });

// ---- Elsewhere ----

/// The mean of the centres of the voxels with a label, in the world.
std::array<double, 3> CentreOf(const Volume& volume, double label) {
    std::array<double, 3> sum{};
    double n = 0;
    for (Offset at = 0; at < volume.n_voxels(); ++at) {
        if (volume.values[static_cast<std::size_t>(at)] != label) continue;
        sum[0] += static_cast<double>(at % volume.dims[0]);
        sum[1] += static_cast<double>(at / volume.dims[0] % volume.dims[1]);
        sum[2] += static_cast<double>(at / volume.dims[0] / volume.dims[1]);
        ++n;
    }
    for (double& x : sum) x /= n;
    return volume.ToWorld(sum);
}

TEST(RealVolumes, TheCaudateNucleiLieWhereTheAtlasSaysTheyAre) {
    const auto path = RealData("../committable/derived_aal_caudate_crop.nii.gz");
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "the atlas: there is no " << path;
    const Volume volume = ReadVolume(path);
    EXPECT_EQ(volume.dims, (std::array<Offset, 3>{82, 92, 72}));
    EXPECT_THAT(Geometry::LabelsOf(volume), testing::ElementsAre(0, 1, 2));
    // Centres of AAL's left and right caudate nucleus in the MNI space, as lists of its regions give them, rounded to
    // millimetres (0.5); the crop's header lies a voxel (1) further left than the atlas.
    const std::array<double, 3> left = CentreOf(volume, 1), right = CentreOf(volume, 2);
    const std::array<double, 3> listed_left = {-11, 11, 9}, listed_right = {15, 12, 9};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(left[k], listed_left[k], 1.5);
        EXPECT_NEAR(right[k], listed_right[k], 1.5);
    }
}

TEST(RealVolumes, SegmentedHeadsAndAToothAreRead) {
    const auto tooth = RealData("volumes/tooth.nhdr");
    if (!std::filesystem::exists(tooth)) GTEST_SKIP() << "the volumes: there is no " << tooth;
    EXPECT_EQ(ReadVolume(tooth).dims, (std::array<Offset, 3>{103, 94, 161}));
    for (const char* name : {"Brain", "BrainSkull", "Skull"}) {
        const Volume volume = ReadVolume(RealData(std::string("volumes/") + name + ".nrrd"));
        EXPECT_EQ(volume.dims, (std::array<Offset, 3>{160, 232, 160})) << name;
        EXPECT_EQ(Geometry::LabelsOf(volume).size(), 2u) << name;
        EXPECT_EQ(volume.Spacing(), (std::array<double, 3>{1, 0.898437, 0.898437})) << name;
    }
}

}  // namespace
}  // namespace SolidSubdiv::Io
