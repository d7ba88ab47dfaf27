#pragma once

#include <string_view>

/// The words that languages reserve, as data; the sources stand in shader_code.hpp.
namespace shadefit::reserved {

/// Words, separated by blanks.
using WordList = std::string_view;

/// Functions of <math.h> and of CUDA without the suffixes of C, and what else stands in the headers of C or
/// what <cmath> and <algorithm> may bring.
inline constexpr WordList c_functions =
    "abort abs acos acosh acospi all any asin asinh asinpi atan atan2 atan2pi atanh atanpi atexit atomicAdd "
    "atomicAnd atomicCAS atomicDec atomicExch atomicInc atomicMax atomicMin atomicOr atomicSub atomicXor "
    "bsearch calloc canonicalize cbrt ceil clock clock64 compoundn copysign cos cosh cospi cyl_bessel_i0 "
    "cyl_bessel_i1 dadd ddiv dfma div dmul drem dsqrt dsub erf erfc erfcinv erfcx erfinv exit exp exp10 exp10m1 "
    "exp2 exp2m1 expm1 fabs fadd fdim fdiv fdivide ffma finite float2int float2uint float_as_int floor fma fmax "
    "fmaximum fmaximum_mag fmaximum_num fmin fminimum fminimum_mag fminimum_num fmod fmul fpclassify free frexp "
    "fromfp fromfpx fsqrt fsub gamma getenv getpayload hceil hcos hexp hexp10 hexp2 hfloor hlog hlog10 hlog2 "
    "hrcp hrint hrsqrt hsin hsqrt htanh htrunc hypot ilogb index int2float int_as_float iscanonical iseqsig "
    "isfinite isgreater isgreaterequal isinf isless islessequal islessgreater isnan isnormal issignaling "
    "issubnormal isunordered iszero j0 j1 jn labs ldexp ldiv lgamma llabs lldiv llmax llmin llogb llrint "
    "llround log log10 log10p1 log1p log2 log2p1 logb logp1 lrint lround malloc memchr memcmp memcpy memmove "
    "memset modf mul24 mul32hi mul64hi mulhi nan nanosleep nearbyint nextafter nextdown nexttoward nextup norm "
    "norm3d norm4d normcdf normcdfinv pow pow10 powi pown powr printf prof_trigger putchar puts qsort rand "
    "random rcbrt read realloc remainder remquo rhypot rindex rint rnorm rnorm3d rnorm4d rootn round roundeven "
    "rsqrt saturate scalb scalbln scalbn scanf select setpayload setpayloadsig signbit signgam significand sin "
    "sincos sincospi sinh sinpi sqrt srand srandom strcat strchr strcmp strcpy strlen surf1Dread surf1Dwrite "
    "surf2Dread surf2Dwrite surf3Dread surf3Dwrite syncthreads system tan tanh tanpi tex1D tex1Dfetch tex1DGrad "
    "tex1DLayered tex1DLod tex2D tex2Dgather tex2DGrad tex2DLayered tex2DLod tex3D tex3DGrad tex3DLod "
    "texCubemap texCubemapLayered tgamma time totalorder totalordermag trunc u_char u_int u_long u_short "
    "ufromfp ufromfpx uint uint2float ullmax ullmin ulong umax umin umul24 umulhi ushort write y0 y1 yn";

/// Keywords, reserved words, types and functions of all languages.
inline constexpr WordList words =
    "abs_diff absdiff abstract accelerationStructureEXT access active add_sat address addsat alias alignas "
    "alignof allInvocations allInvocationsEqual AllMemoryBarrier AllMemoryBarrierWithGroupSync "
    "allow_uav_condition and and_eq anyInvocation AppendStructuredBuffer array arrayLength as asdouble asfloat "
    "asint asm asm_fragment assert assoc_legendre asuint async async_work_group_copy atomic "
    "atomicCompareExchangeWeak atomicCompSwap atomicCounter atomicCounterDecrement atomicCounterIncrement "
    "atomicExchange atomicLoad atomicStore attribute auto await barrier become beta bfloat bit_reverse bitand "
    "bitcast bitCount bitfieldExtract bitfieldInsert bitfieldReverse bitor bitselect BlendState blockDim "
    "blockIdx bool branch break Buffer buffer ByteAddressBuffer call case cast catch cbuffer centroid char "
    "CheckAccessFullyMapped cl_mem_fence_flags clamp class clip clz co_await co_return co_yield coherent "
    "column_major common compare_func compile compile_fragment CompileShader compl complex ComputeShader "
    "concept const const_assert const_cast constant ConstantBuffer consteval constexpr constinit "
    "ConsumeStructuredBuffer continue continuing coord countbits countLeadingZeros countOneBits "
    "countTrailingZeros crate cross ctz D3DCOLORtoUBYTE4 ddx ddx_coarse ddx_fine ddy ddy_coarse ddy_fine "
    "debugger decltype default degrees delete demote demote_to_helper DepthStencilState DepthStencilView "
    "determinant device DeviceMemoryBarrier DeviceMemoryBarrierWithGroupSync dFdx dfdx dFdxCoarse dFdxFine dFdy "
    "dfdy dFdyCoarse dFdyFine diagnostic dim3 discard discard_fragment distance distance_squared divide do "
    "DomainShader dot dot4I8Packed dot4U8Packed double dpdx dpdxCoarse dpdxFine dpdy dpdyCoarse dpdyFine dst "
    "dword dynamic_cast else EmitStreamVertex EmitVertex enable EndPrimitive EndStreamPrimitive enum equal "
    "errno errorf EvaluateAttributeAtCentroid EvaluateAttributeAtSample EvaluateAttributeSnapped expint "
    "explicit export extends extern external extract_bits extractBits f16 f16tof32 f32 f32tof16 faceForward "
    "faceforward fallthrough false fast_distance fast_length fast_normalize fastopt filter final finally "
    "findLSB findMSB firstbithigh firstbitlow firstLeadingBit firstTrailingBit fixed flat flatten float "
    "floatBitsToInt floatBitsToUint fmax3 fmedian3 fmin3 fn for forcecase fortran frac fract fragment friend "
    "from ftransform fwidth fwidthCoarse fwidthFine fxgroup generic GeometryShader get get_global_id "
    "get_global_offset get_global_size get_group_id get_image_depth get_image_dim get_image_height "
    "get_image_width get_local_id get_local_size get_num_groups get_work_dim GetRenderTargetSampleCount "
    "GetRenderTargetSamplePosition global globallycoherent goto greaterThan greaterThanEqual gridDim "
    "GroupMemoryBarrier groupMemoryBarrier GroupMemoryBarrierWithGroupSync groupshared hadd half half_cos "
    "half_divide half_exp half_exp10 half_exp2 half_log half_log10 half_log2 half_powr half_recip half_rsqrt "
    "half_sin half_sqrt half_tan highp Hullshader i32 if iimage image imageAtomicAdd imageAtomicAnd "
    "imageAtomicCompSwap imageAtomicExchange imageAtomicMax imageAtomicMin imageAtomicOr imageAtomicXor "
    "imageLoad imageSamples imageSize imageStore imaginary impl implements import imulExtended in inline inout "
    "input InputPatch insert_bits insertBits instanceof int intBitsToFloat interface InterlockedAdd "
    "InterlockedAnd InterlockedCompareExchange InterlockedCompareStore InterlockedExchange InterlockedMax "
    "InterlockedMin InterlockedOr InterlockedXor interpolateAtCentroid interpolateAtOffset interpolateAtSample "
    "intersection invariant inverse inverseSqrt inversesqrt isampler isequal isnotequal isordered itexture "
    "kernel kernel_exec layout legendre length length_squared lerp lessThan lessThanEqual let lgamma_r line "
    "lineadj linear LineStream lit local long loop lowp macro macro_rules mad mad24 mad_hi mad_sat madhi madsat "
    "main match math_errhandling matrix matrixCompMult max max3 maxmag median3 mediump mem_fence memory_order "
    "memory_scope memoryBarrier memoryBarrierAtomicCounter memoryBarrierBuffer memoryBarrierImage "
    "memoryBarrierShared mesh meta metal min min10float min12int min16float min16int min16uint min3 minmag mix "
    "mod module move msad4 mul mul_hi mut mutable namespace native_cos native_divide native_exp native_exp10 "
    "native_exp2 native_log native_log10 native_log2 native_powr native_recip native_rsqrt native_sin "
    "native_sqrt native_tan new nil noexcept noinline nointerpolation noise noise1 noise2 noise3 noise4 "
    "non_coherent noncoherent noperspective normalize not not_eq notEqual NULL null nullptr nv_bfloat16 "
    "nv_bfloat162 object object_data of operator or or_eq out outerProduct output OutputPatch override "
    "pack2x16float pack2x16snorm pack2x16unorm pack4x8snorm pack4x8unorm package packDouble2x32 packed "
    "packHalf2x16 packoffset packSnorm2x16 packSnorm4x8 packUnorm2x16 packUnorm4x8 partition pass patch pipe "
    "pixelfragment PixelShader point PointStream popcount precise precision prefetch premerge priv private "
    "Process2DQuadTessFactorsAvg Process2DQuadTessFactorsMax Process2DQuadTessFactorsMin "
    "ProcessIsolineTessFactors ProcessQuadTessFactorsAvg ProcessQuadTessFactorsMax ProcessQuadTessFactorsMin "
    "ProcessTriTessFactorsAvg ProcessTriTessFactorsMax ProcessTriTessFactorsMin protected ptr pub public quad "
    "quantizeToF16 radians RasterizerState ray_data rayPayloadEXT rcp read_imagef read_imageh read_imagei "
    "read_imageui read_mem_fence read_only read_write readonly ref reflect refract regardless register "
    "reinterpret_cast RenderTargetView require requires resource restrict return reverse_bits reverseBits "
    "reversebits rhadd rotate roundEven row_major RWBuffer RWByteAddressBuffer RWStructuredBuffer RWTexture1D "
    "RWTexture1DArray RWTexture2D RWTexture2DArray RWTexture3D sample sampler sampler_comparison sampler_state "
    "SamplerComparisonState samplerCUBE SamplerState Self self set shadow1D shadow1DLod shadow1DProj shadow2D "
    "shadow2DLod shadow2DProj shared short shuffle shuffle2 sign signed simdgroup_barrier sizeof smooth "
    "smoothstep snorm stateblock stateblock_state static static_assert static_cast std step storageBarrier "
    "string struct StructuredBuffer sub_sat subpassLoad subroutine subsat super superp surface switch target "
    "tbuffer technique technique10 technique11 template terminateInvocation tex1Dbias tex1Dgrad tex1Dlod "
    "tex1Dproj tex2Dbias tex2Dgrad tex2Dlod tex2Dproj tex3Dbias tex3Dgrad tex3Dlod tex3Dproj texCUBE "
    "texCUBEbias texCUBEgrad texCUBElod texCUBEproj texelFetch texelFetchOffset texture Texture1D texture1d "
    "Texture1DArray Texture2D texture2d Texture2DArray Texture2DMS Texture2DMSArray Texture3D texture3d "
    "texture_1d texture_2d texture_3d texture_cube textureBarrier TextureBuffer TextureCube textureCUBE "
    "texturecube TextureCubeArray textureDimensions textureGather textureGatherCompare textureGatherOffset "
    "textureGatherOffsets textureGrad textureGradOffset textureLoad textureLod textureLodOffset "
    "textureNumLayers textureNumLevels textureNumSamples textureOffset textureProj textureProjGrad "
    "textureProjGradOffset textureProjLod textureProjLodOffset textureProjOffset textureQueryLevels "
    "textureQueryLod textureSample textureSampleBaseClampToEdge textureSampleBias textureSampleCompare "
    "textureSampleCompareLevel textureSampleGrad textureSampleLevel textureSamples textureSize textureStore "
    "this thread thread_local threadgroup threadgroup_barrier threadgroup_imageblock threadIdx throw tile trait "
    "transpose triangle triangleadj TriangleStream true try type typedef typeid typename typeof typeof_unqual "
    "u32 uaddCarry uchar uimage uintBitsToFloat umulExtended uniform union unless unorm unpack2x16float "
    "unpack2x16snorm unpack2x16unorm unpack4x8snorm unpack4x8unorm unpackDouble2x32 unpackHalf2x16 "
    "unpackSnorm2x16 unpackSnorm4x8 unpackUnorm2x16 unpackUnorm4x8 unroll unsafe unsigned unsized upsample "
    "usampler use using usubBorrow utexture var varying vec2f vec2h vec2i vec2u vec3f vec3h vec3i vec3u vec4f "
    "vec4h vec4i vec4u vec_step vector vertex vertexfragment VertexShader virtual visible void volatile "
    "wait_group_events warpSize wgsl where while with workgroupBarrier workgroupUniformLoad write_imagef "
    "write_imageh write_imagei write_imageui write_mem_fence write_only writeonly xor xor_eq yield";

/// Bases of the types of vectors and matrices.
inline constexpr WordList vector_types =
    "float half double int uint bool short ushort char uchar long ulong dword min16float min10float min16int "
    "min12int min16uint int16_t uint16_t int32_t uint32_t int64_t uint64_t float16_t float32_t float64_t "
    "longlong ulonglong vec bvec ivec uvec dvec hvec fvec mat dmat bfloat packed_float packed_half packed_int "
    "packed_uint simd";

/// Forms of names that a language reserves for itself and its implementations; '*' is any text.
inline constexpr WordList forms =
    "*__* _* *_t gl_* make_* as_* convert_* vload* vstore* atom_* atomic_* work_group_* sub_group_* "
    "*sampler[123]D* *samplerCube* *samplerBuffer *samplerShadow samplerExternalOES *image[123]D* *imageCube* "
    "*imageBuffer *texture[123]D* *textureCube* *textureBuffer *subpassInput*";

}  // namespace shadefit::reserved
