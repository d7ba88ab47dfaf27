#pragma once

#include <string_view>

/// The words that languages reserve, as data; the sources stand in shader_code.hpp.
namespace shadefit::reserved {

/// Words, separated by blanks.
using WordList = std::string_view;

/// Words of C that are keywords or reserved in C++, HLSL, MSL and GLSL.
inline constexpr WordList c_words =
    "auto break case char const continue default do double else enum extern float for goto if inline int long "
    "register return short signed sizeof static struct switch typedef union unsigned void volatile while bool "
    "true false main";

inline constexpr WordList only_c_words =
    "restrict alignas alignof constexpr nullptr static_assert thread_local typeof typeof_unqual asm fortran "
    "errno math_errhandling assert";

inline constexpr WordList cpp_words =
    "alignas alignof and and_eq asm bitand bitor catch char8_t char16_t char32_t class compl concept consteval "
    "constexpr constinit const_cast co_await co_return co_yield decltype delete dynamic_cast explicit export "
    "friend mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public "
    "reinterpret_cast requires static_assert static_cast template this thread_local throw try typeid typename "
    "using virtual wchar_t xor xor_eq std errno math_errhandling";

/// The functions of <math.h> without the suffixes f and l, and what else stands in the headers of C that
/// <cmath> and <algorithm> may bring.
inline constexpr WordList c_functions =
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

inline constexpr WordList cpp_functions = "min max clamp lerp beta expint legendre assoc_legendre";

inline constexpr WordList glsl_words =
    "attribute uniform varying buffer shared coherent restrict readonly writeonly atomic_uint layout centroid "
    "flat smooth noperspective patch sample invariant precise discard subroutine in out inout lowp mediump highp "
    "precision common partition active asm class template this resource noinline public external interface half "
    "fixed superp input output filter sizeof cast namespace using sampler3DRect uint mat2 mat3 mat4 "
    "demote terminateInvocation rayPayloadEXT accelerationStructureEXT";

inline constexpr WordList glsl_functions =
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

inline constexpr WordList hlsl_words =
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

inline constexpr WordList hlsl_functions =
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

inline constexpr WordList wgsl_words =
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

inline constexpr WordList wgsl_functions =
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

inline constexpr WordList msl_words =
    "metal kernel vertex fragment device constant thread threadgroup threadgroup_imageblock ray_data object_data "
    "half uint ushort uchar ulong size_t ptrdiff_t bfloat sampler texture1d texture2d texture3d texturecube array "
    "atomic_int atomic_uint atomic_bool visible mesh object intersection tile access address compare_func coord "
    "filter matrix packed restrict";

inline constexpr WordList msl_functions =
    "abs absdiff addsat clamp clz ctz extract_bits hadd insert_bits mad24 madhi madsat max max3 median3 min min3 "
    "mul24 mulhi popcount reverse_bits rhadd rotate subsat all any isfinite isinf isnan isnormal isordered "
    "isunordered not select signbit mix saturate sign smoothstep step acos acosh asin asinh atan atan2 atanh ceil "
    "copysign cos cosh cospi divide exp exp10 exp2 fabs fdim floor fma fmax fmax3 fmedian3 fmin fmin3 fmod fract "
    "frexp ilogb ldexp log log10 log2 modf nextafter pow powr rint round rsqrt sin sincos sinh sinpi sqrt tan tanh "
    "tanpi trunc determinant transpose cross distance distance_squared dot faceforward length length_squared "
    "normalize reflect refract as_type dfdx dfdy fwidth discard_fragment threadgroup_barrier simdgroup_barrier";

inline constexpr WordList cuda_words =
    "threadIdx blockIdx blockDim gridDim warpSize dim3 half half2 nv_bfloat16 nv_bfloat162 cudaError_t cudaStream_t "
    "cudaEvent_t cudaTextureObject_t cudaSurfaceObject_t texture surface uchar ushort uint ulong";

inline constexpr WordList cuda_functions =
    "cyl_bessel_i0 cyl_bessel_i1 erfcinv erfcx erfinv fdivide norm norm3d norm4d normcdf normcdfinv rcbrt rhypot "
    "rnorm rnorm3d rnorm4d sincospi saturate mulhi mul24 umul24 umulhi mul64hi mul32hi llmax llmin ullmax ullmin umax "
    "umin powi float_as_int int_as_float float2int float2uint int2float uint2float clock64 nanosleep all any syncthreads prof_trigger "
    "atomicAdd atomicSub atomicExch atomicMin atomicMax atomicInc atomicDec atomicCAS atomicAnd atomicOr atomicXor "
    "tex1D tex2D tex3D tex1Dfetch tex1DLod tex2DLod tex3DLod tex1DGrad tex2DGrad tex3DGrad tex2Dgather texCubemap "
    "tex1DLayered tex2DLayered texCubemapLayered surf1Dread surf2Dread surf3Dread surf1Dwrite surf2Dwrite surf3Dwrite "
    "hexp hexp2 hexp10 hlog hlog2 hlog10 hsqrt hrsqrt hrcp hsin hcos hceil hfloor hrint htrunc htanh";

inline constexpr WordList opencl_words =
    "kernel global local constant private generic read_only write_only read_write pipe uniform half quad complex "
    "imaginary bool uchar ushort uint ulong size_t ptrdiff_t intptr_t uintptr_t event_t sampler_t queue_t clk_event_t "
    "reserve_id_t ndrange_t image1d_t image1d_array_t image1d_buffer_t image2d_t image2d_array_t image2d_depth_t "
    "image2d_array_depth_t image3d_t cl_mem_fence_flags memory_order memory_scope atomic_int atomic_uint atomic_long "
    "atomic_ulong atomic_float atomic_double atomic_flag kernel_exec restrict vec_step";

inline constexpr WordList opencl_functions =
    "acos acosh acospi asin asinh asinpi atan atan2 atanh atanpi atan2pi cbrt ceil copysign cos cosh cospi erf erfc "
    "exp exp2 exp10 expm1 fabs fdim floor fma fmax fmin fmod fract frexp hypot ilogb ldexp lgamma lgamma_r log log2 "
    "log10 log1p logb mad maxmag minmag modf nan nextafter pow pown powr remainder remquo rint rootn round rsqrt sin "
    "sincos sinh sinpi sqrt tan tanh tanpi tgamma trunc native_cos native_divide native_exp native_exp2 native_exp10 "
    "native_log native_log2 native_log10 native_powr native_recip native_rsqrt native_sin native_sqrt native_tan "
    "half_cos half_divide half_exp half_exp2 half_exp10 half_log half_log2 half_log10 half_powr half_recip half_rsqrt "
    "half_sin half_sqrt half_tan abs abs_diff add_sat bit_reverse clamp clz ctz hadd mad24 mad_hi mad_sat max min mul24 mul_hi popcount "
    "rhadd rotate sub_sat upsample degrees mix radians sign smoothstep step cross distance dot fast_distance "
    "fast_length fast_normalize length normalize all any bitselect isequal isfinite isgreater isgreaterequal isinf "
    "isless islessequal islessgreater isnan isnormal isnotequal isordered isunordered select signbit shuffle shuffle2 "
    "barrier mem_fence read_mem_fence write_mem_fence prefetch async_work_group_copy wait_group_events get_work_dim "
    "get_global_size get_global_id get_local_size get_local_id get_num_groups get_group_id get_global_offset "
    "read_imagef read_imageh read_imagei read_imageui write_imagef write_imageh write_imagei write_imageui "
    "get_image_width get_image_height get_image_depth get_image_dim printf";

/// Bases of the types of vectors and matrices.
inline constexpr WordList vector_types =
    "float half double int uint bool short ushort char uchar long ulong dword min16float min10float min16int "
    "min12int min16uint int16_t uint16_t int32_t uint32_t int64_t uint64_t float16_t float32_t float64_t "
    "longlong ulonglong vec bvec ivec uvec dvec hvec fvec mat dmat bfloat packed_float packed_half packed_int packed_uint simd";

}  // namespace shadefit::reserved
