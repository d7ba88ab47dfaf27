#include "reports/code/reserved_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>

namespace shadefit {
namespace {

/// Words, separated by blanks.
using WordList = std::string_view;

/// Whether a list holds a word.
bool holds_word(WordList words, std::string_view word) {
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    if (words.substr(begin, end - begin) == word) return true;
    begin = end + 1;
  }
  return false;
}

/// Words of C that are keywords or reserved in C++, HLSL, MSL and GLSL.
constexpr WordList c_words =
    "auto break case char const continue default do double else enum extern float for goto if inline int long "
    "register return short signed sizeof static struct switch typedef union unsigned void volatile while bool "
    "true false main";

constexpr WordList only_c_words =
    "restrict alignas alignof constexpr nullptr static_assert thread_local typeof typeof_unqual asm fortran "
    "errno math_errhandling assert";

constexpr WordList cpp_words =
    "alignas alignof and and_eq asm bitand bitor catch char8_t char16_t char32_t class compl concept consteval "
    "constexpr constinit const_cast co_await co_return co_yield decltype delete dynamic_cast explicit export "
    "friend mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public "
    "reinterpret_cast requires static_assert static_cast template this thread_local throw try typeid typename "
    "using virtual wchar_t xor xor_eq std errno math_errhandling";

/// The functions of <math.h> without the suffixes f and l, and what else stands in the headers of C that
/// <cmath> and <algorithm> may bring.
constexpr WordList c_functions =
    "acos asin atan atan2 cos sin tan acospi asinpi atanpi atan2pi cospi sinpi tanpi acosh asinh atanh cosh sinh "
    "tanh exp exp10 exp10m1 exp2 exp2m1 expm1 frexp ilogb ldexp llogb log log10 log10p1 log1p logp1 log2 log2p1 "
    "logb modf scalbn scalbln cbrt compoundn fabs hypot pow pown powr rootn rsqrt sqrt erf erfc lgamma tgamma "
    "ceil floor nearbyint rint lrint llrint round lround llround roundeven trunc fromfp ufromfp fromfpx ufromfpx "
    "fmod remainder remquo copysign nan nextafter nexttoward nextup nextdown canonicalize fdim fmax fmin "
    "fmaximum fminimum fmaximum_mag fminimum_mag fmaximum_num fminimum_num fma fadd fsub fmul fdiv ffma fsqrt "
    "dadd dsub dmul ddiv dfma dsqrt totalorder totalordermag getpayload setpayload setpayloadsig "
    "j0 j1 jn y0 y1 yn gamma drem significand scalb finite isinf isnan fpclassify isfinite isnormal signbit "
    "iscanonical issignaling issubnormal iszero isgreater isgreaterequal isless islessequal islessgreater "
    "isunordered iseqsig sincos pow10 signgam float_t double_t abs labs llabs div ldiv lldiv abort exit atexit "
    "malloc calloc realloc free qsort bsearch rand srand random srandom system getenv memcpy memmove memset "
    "memcmp memchr strlen strcpy strcmp strcat strchr printf puts putchar scanf time clock select read write "
    "index rindex uint ushort ulong u_int u_char u_short u_long";

constexpr WordList cpp_functions = "min max clamp lerp beta expint legendre assoc_legendre";

constexpr WordList glsl_words =
    "attribute uniform varying buffer shared coherent restrict readonly writeonly atomic_uint layout centroid "
    "flat smooth noperspective patch sample invariant precise discard subroutine in out inout lowp mediump highp "
    "precision common partition active asm class template this resource noinline public external interface half "
    "fixed superp input output filter sizeof cast namespace using sampler3DRect uint mat2 mat3 mat4 "
    "demote terminateInvocation rayPayloadEXT accelerationStructureEXT";

constexpr WordList glsl_functions =
    "radians degrees sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh pow exp log exp2 log2 sqrt "
    "inversesqrt abs sign floor trunc round roundEven ceil fract mod modf min max clamp mix step smoothstep isnan "
    "isinf floatBitsToInt floatBitsToUint intBitsToFloat uintBitsToFloat fma frexp ldexp packUnorm2x16 "
    "packSnorm2x16 packUnorm4x8 packSnorm4x8 unpackUnorm2x16 unpackSnorm2x16 unpackUnorm4x8 unpackSnorm4x8 "
    "packHalf2x16 unpackHalf2x16 packDouble2x32 unpackDouble2x32 length distance dot cross normalize ftransform "
    "faceforward reflect refract matrixCompMult outerProduct transpose determinant inverse lessThan lessThanEqual "
    "greaterThan greaterThanEqual equal notEqual any all not uaddCarry usubBorrow umulExtended imulExtended "
    "bitfieldExtract bitfieldInsert bitfieldReverse bitCount findLSB findMSB texture textureSize textureQueryLod "
    "textureQueryLevels textureSamples textureProj textureLod textureOffset texelFetch texelFetchOffset "
    "textureProjOffset textureLodOffset textureProjLod textureProjLodOffset textureGrad textureGradOffset "
    "textureProjGrad textureProjGradOffset textureGather textureGatherOffset textureGatherOffsets texture1D "
    "texture2D texture3D textureCube texture1DProj texture2DProj texture1DLod texture2DLod texture2DProjLod "
    "textureCubeLod texture2DRect shadow1D shadow2D shadow1DProj shadow2DProj shadow1DLod shadow2DLod "
    "atomicCounter atomicCounterIncrement atomicCounterDecrement atomicAdd atomicMin atomicMax atomicAnd atomicOr "
    "atomicXor atomicExchange atomicCompSwap imageSize imageSamples imageLoad imageStore imageAtomicAdd "
    "imageAtomicMin imageAtomicMax imageAtomicAnd imageAtomicOr imageAtomicXor imageAtomicExchange "
    "imageAtomicCompSwap dFdx dFdy dFdxFine dFdyFine dFdxCoarse dFdyCoarse fwidth fwidthFine fwidthCoarse "
    "interpolateAtCentroid interpolateAtSample interpolateAtOffset noise1 noise2 noise3 noise4 EmitStreamVertex "
    "EndStreamPrimitive EmitVertex EndPrimitive barrier memoryBarrier memoryBarrierAtomicCounter "
    "memoryBarrierBuffer memoryBarrierShared memoryBarrierImage groupMemoryBarrier subpassLoad anyInvocation "
    "allInvocations allInvocationsEqual";

constexpr WordList hlsl_words =
    "AppendStructuredBuffer asm asm_fragment BlendState Buffer ByteAddressBuffer cbuffer centroid class "
    "column_major compile compile_fragment CompileShader ComputeShader ConsumeStructuredBuffer DepthStencilState "
    "DepthStencilView discard DomainShader dword export fxgroup GeometryShader groupshared half Hullshader in "
    "inout InputPatch interface line lineadj linear LineStream matrix min16float min10float min16int min12int "
    "min16uint namespace nointerpolation noperspective NULL out OutputPatch packoffset pass pixelfragment "
    "PixelShader point PointStream precise RasterizerState RenderTargetView row_major RWBuffer RWByteAddressBuffer "
    "RWStructuredBuffer RWTexture1D RWTexture1DArray RWTexture2D RWTexture2DArray RWTexture3D sample sampler "
    "SamplerState SamplerComparisonState sampler1D sampler2D sampler3D samplerCUBE sampler_state shared snorm "
    "stateblock stateblock_state string StructuredBuffer tbuffer technique technique10 technique11 texture "
    "Texture1D Texture1DArray Texture2D Texture2DArray Texture2DMS Texture2DMSArray Texture3D TextureCube "
    "TextureCubeArray triangle triangleadj TriangleStream uint uniform unorm unsigned vector vertexfragment "
    "VertexShader catch const_cast delete dynamic_cast explicit friend mutable new operator private protected "
    "public reinterpret_cast static_cast template this throw try typename using virtual int64_t uint64_t "
    "float16_t float32_t float64_t int16_t uint16_t int32_t uint32_t ConstantBuffer TextureBuffer unroll loop "
    "flatten branch forcecase call fastopt allow_uav_condition globallycoherent lineadj "
    "InputPatch texture1D texture2D texture3D textureCUBE";

constexpr WordList hlsl_functions =
    "abort abs acos all AllMemoryBarrier AllMemoryBarrierWithGroupSync any asdouble asfloat asin asint asuint "
    "atan atan2 ceil CheckAccessFullyMapped clamp clip cos cosh countbits cross D3DCOLORtoUBYTE4 ddx ddx_coarse "
    "ddx_fine ddy ddy_coarse ddy_fine degrees determinant DeviceMemoryBarrier DeviceMemoryBarrierWithGroupSync "
    "distance dot dst errorf EvaluateAttributeAtCentroid EvaluateAttributeAtSample EvaluateAttributeSnapped exp "
    "exp2 f16tof32 f32tof16 faceforward firstbithigh firstbitlow floor fma fmod frac frexp fwidth "
    "GetRenderTargetSampleCount GetRenderTargetSamplePosition GroupMemoryBarrier GroupMemoryBarrierWithGroupSync "
    "InterlockedAdd InterlockedAnd InterlockedCompareExchange InterlockedCompareStore InterlockedExchange "
    "InterlockedMax InterlockedMin InterlockedOr InterlockedXor isfinite isinf isnan ldexp length lerp lit log "
    "log10 log2 mad max min modf msad4 mul noise normalize pow printf Process2DQuadTessFactorsAvg "
    "Process2DQuadTessFactorsMax Process2DQuadTessFactorsMin ProcessIsolineTessFactors ProcessQuadTessFactorsAvg "
    "ProcessQuadTessFactorsMax ProcessQuadTessFactorsMin ProcessTriTessFactorsAvg ProcessTriTessFactorsMax "
    "ProcessTriTessFactorsMin radians rcp reflect refract reversebits round rsqrt saturate sign sin sincos sinh "
    "smoothstep sqrt step tan tanh tex1D tex1Dbias tex1Dgrad tex1Dlod tex1Dproj tex2D tex2Dbias tex2Dgrad "
    "tex2Dlod tex2Dproj tex3D tex3Dbias tex3Dgrad tex3Dlod tex3Dproj texCUBE texCUBEbias texCUBEgrad texCUBElod "
    "texCUBEproj transpose trunc and or select";

constexpr WordList wgsl_words =
    "alias break case const const_assert continue continuing default diagnostic discard else enable false fn for "
    "if let loop override requires return struct switch true var while NULL Self abstract active alignas alignof "
    "as asm asm_fragment async attribute auto await become cast catch class co_await co_return co_yield coherent "
    "column_major common compile compile_fragment concept const_cast consteval constexpr constinit crate debugger "
    "decltype delete demote demote_to_helper do dynamic_cast enum explicit export extends extern external "
    "fallthrough filter final finally friend from fxgroup get goto groupshared highp impl implements import inline "
    "instanceof interface layout lowp macro macro_rules match mediump meta mod module move mut mutable namespace "
    "new nil noexcept noinline nointerpolation non_coherent noncoherent noperspective null nullptr of operator "
    "package packoffset partition pass patch pixelfragment precise precision premerge priv protected pub public "
    "readonly ref regardless register reinterpret_cast require resource restrict self set shared sizeof smooth "
    "snorm static static_assert static_cast std subroutine super target template this thread_local throw trait "
    "try type typedef typeid typename typeof union unless unorm unsafe unsized use using varying virtual volatile "
    "wgsl where with writeonly yield bool f16 f32 i32 u32 vec2 vec3 vec4 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 "
    "mat3x4 mat4x2 mat4x3 mat4x4 array atomic ptr sampler sampler_comparison texture_1d texture_2d texture_3d "
    "texture_cube vec2f vec3f vec4f vec2h vec3h vec4h vec2i vec3i vec4i vec2u vec3u vec4u";

constexpr WordList wgsl_functions =
    "bitcast all any select arrayLength abs acos acosh asin asinh atan atanh atan2 ceil clamp cos cosh "
    "countLeadingZeros countOneBits countTrailingZeros cross degrees determinant distance dot dot4U8Packed "
    "dot4I8Packed exp exp2 extractBits faceForward firstLeadingBit firstTrailingBit floor fma fract frexp "
    "insertBits inverseSqrt ldexp length log log2 max min mix modf normalize pow quantizeToF16 radians reflect "
    "refract reverseBits round saturate sign sin sinh smoothstep sqrt step tan tanh transpose trunc dpdx "
    "dpdxCoarse dpdxFine dpdy dpdyCoarse dpdyFine fwidth fwidthCoarse fwidthFine textureDimensions textureGather "
    "textureGatherCompare textureLoad textureNumLayers textureNumLevels textureNumSamples textureSample "
    "textureSampleBias textureSampleCompare textureSampleCompareLevel textureSampleGrad textureSampleLevel "
    "textureSampleBaseClampToEdge textureStore atomicLoad atomicStore atomicAdd atomicSub atomicMax atomicMin "
    "atomicAnd atomicOr atomicXor atomicExchange atomicCompareExchangeWeak pack4x8snorm pack4x8unorm pack2x16snorm "
    "pack2x16unorm pack2x16float unpack4x8snorm unpack4x8unorm unpack2x16snorm unpack2x16unorm unpack2x16float "
    "storageBarrier textureBarrier workgroupBarrier workgroupUniformLoad";

constexpr WordList msl_words =
    "metal kernel vertex fragment device constant thread threadgroup threadgroup_imageblock ray_data object_data "
    "half uint ushort uchar ulong size_t ptrdiff_t bfloat sampler texture1d texture2d texture3d texturecube array "
    "atomic_int atomic_uint atomic_bool visible mesh object intersection tile access address compare_func coord "
    "filter matrix packed restrict";

constexpr WordList msl_functions =
    "abs absdiff addsat clamp clz ctz extract_bits hadd insert_bits mad24 madhi madsat max max3 median3 min min3 "
    "mul24 mulhi popcount reverse_bits rhadd rotate subsat all any isfinite isinf isnan isnormal isordered "
    "isunordered not select signbit mix saturate sign smoothstep step acos acosh asin asinh atan atan2 atanh ceil "
    "copysign cos cosh cospi divide exp exp10 exp2 fabs fdim floor fma fmax fmax3 fmedian3 fmin fmin3 fmod fract "
    "frexp ilogb ldexp log log10 log2 modf nextafter pow powr rint round rsqrt sin sincos sinh sinpi sqrt tan tanh "
    "tanpi trunc determinant transpose cross distance distance_squared dot faceforward length length_squared "
    "normalize reflect refract as_type dfdx dfdy fwidth discard_fragment threadgroup_barrier simdgroup_barrier";

/// "float3x3" as "float", "vec2" as "vec": what is before the counts of a vector or a matrix; empty where
/// there are none.
std::string_view base_of_type(std::string_view name) {
  const auto is_count = [&](std::size_t i) { return i < name.size() && name[i] >= '1' && name[i] <= '4'; };
  const std::size_t size = name.size();
  if (size > 3 && is_count(size - 1) && name[size - 2] == 'x' && is_count(size - 3))
    return name.substr(0, size - 3);
  return size > 1 && is_count(size - 1) ? name.substr(0, size - 1) : "";
}

/// Bases of the types of vectors and matrices.
constexpr WordList vector_types =
    "float half double int uint bool short ushort char uchar long ulong dword min16float min10float min16int "
    "min12int min16uint int16_t uint16_t int32_t uint32_t int64_t uint64_t float16_t float32_t float64_t "
    "vec bvec ivec uvec dvec hvec fvec mat dmat bfloat packed_float packed_half packed_int packed_uint simd";

/// Types of GLSL's textures begin with one of these.
bool is_opaque_type(std::string_view name) {
  for (const std::string_view prefix :
       {"sampler", "isampler", "usampler", "image", "iimage", "uimage", "texture", "itexture", "utexture",
        "subpassInput", "isubpassInput", "usubpassInput"}) {
    if (!name.starts_with(prefix)) continue;
    const std::string_view rest = name.substr(prefix.size());
    if (rest.empty() || rest == "Buffer" || rest == "Shadow" || rest.starts_with("1D") ||
        rest.starts_with("2D") || rest.starts_with("3D") || rest.starts_with("Cube") || rest == "MS" ||
        rest == "ExternalOES")
      return true;
  }
  return false;
}

/// A function of C's library, with its suffix for float, long double, _FloatN or a decimal type.
bool is_c_function(std::string_view name) {
  for (const std::string_view suffix : {"", "f", "l", "f16", "f32", "f64", "f128", "f32x", "f64x", "d32",
                                        "d64", "d128", "_r", "f_r", "l_r"}) {
    if (name.ends_with(suffix) && holds_word(c_functions, name.substr(0, name.size() - suffix.size())))
      return true;
  }
  return false;
}

bool is_any_of(std::string_view name, std::initializer_list<WordList> lists) {
  return std::any_of(lists.begin(), lists.end(), [&](WordList list) { return holds_word(list, name); });
}

bool is_word(std::string_view name, Language language) {
  const bool is_type = holds_word(vector_types, base_of_type(name));
  switch (language) {
    case Language::glsl:
      return is_type || is_opaque_type(name) || is_any_of(name, {c_words, glsl_words});
    case Language::hlsl:
      return is_type || is_any_of(name, {c_words, hlsl_words});
    case Language::c:
      return is_any_of(name, {c_words, only_c_words});
    case Language::cpp:
      return is_any_of(name, {c_words, cpp_words});
    case Language::wgsl:
      return holds_word(wgsl_words, name);
    case Language::msl:
      return is_type || is_any_of(name, {c_words, cpp_words, msl_words});
  }
  return false;
}

bool is_function(std::string_view name, Language language) {
  switch (language) {
    case Language::glsl:
      return holds_word(glsl_functions, name);
    case Language::hlsl:
      return holds_word(hlsl_functions, name);
    case Language::c:
      return is_c_function(name);
    case Language::cpp:
      return is_c_function(name) || holds_word(cpp_functions, name);
    case Language::wgsl:
      return holds_word(wgsl_functions, name);
    case Language::msl:
      return holds_word(msl_functions, name);
  }
  return false;
}

/// Forms of names that a language reserves for itself and its implementations.
bool is_reserved_form(std::string_view name, Language language) {
  const bool has_two = name.find("__") != std::string_view::npos;
  switch (language) {
    case Language::glsl:
      return has_two || name.starts_with("gl_");
    case Language::wgsl:
      return name == "_" || name.starts_with("__");
    case Language::hlsl:
      return has_two;
    case Language::c:
    case Language::cpp:
      return has_two || name.starts_with('_') || name.ends_with("_t");  // the last by POSIX.1, 2.2.2
    case Language::msl:
      return has_two || name.starts_with('_');
  }
  return false;
}

}  // namespace

std::string_view reason_to_refuse_name(std::string_view name, Language language) {
  if (is_word(name, language)) return "it is a word of the language";
  if (is_function(name, language)) return "it is a function of the language or its library";
  if (is_reserved_form(name, language)) return "names of that form are reserved";
  return "";
}

}  // namespace shadefit
