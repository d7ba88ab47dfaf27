'use strict';
const { load } = require('./packages');

/** A compute shader around a generated function: element i of the output is the function of elements i of the inputs. */
function shaderOf(code, name, count) {
  const bindings = Array.from({ length: count }, (_, i) => `@group(0) @binding(${i}) var<storage, read> in${i}: array<f32>;\n`).join('');
  const list = Array.from({ length: count }, (_, i) => `in${i}[at.x]`).join(', ');
  return `${code}\n${bindings}@group(0) @binding(${count}) var<storage, read_write> result: array<f32>;\n` +
    `@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) at: vec3<u32>) {\n  result[at.x] = ${name}(${list});\n}\n`;
}

/** Runs WGSL by Dawn on the Vulkan device that VK_ICD_FILENAMES names. */
class Gpu {
  static async open() {
    const { create, globals } = await load('webgpu'), gpu = new Gpu();
    Object.assign(globalThis, globals);
    gpu.instance = create(['backend=vulkan']);  // the device lives as long as this
    const adapter = await gpu.instance.requestAdapter();
    if (!adapter) throw new Error('Dawn finds no Vulkan device: is VK_ICD_FILENAMES right?');
    gpu.name = adapter.info.device || adapter.info.description;
    gpu.device = await adapter.requestDevice();
    return gpu;
  }

  bufferOf(size, usage) {
    return this.device.createBuffer({ size, usage });
  }

  /** The function of each element of the inputs, arrays of floats of one length, a multiple of 64. */
  async run(code, name, inputs) {
    const { device } = this, size = inputs[0].byteLength;
    device.pushErrorScope('validation');
    const module = device.createShaderModule({ code: shaderOf(code, name, inputs.length) });
    const pipeline = device.createComputePipeline({ layout: 'auto', compute: { module, entryPoint: 'main' } });
    const buffers = inputs.map(values => {
      const buffer = this.bufferOf(size, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST);
      device.queue.writeBuffer(buffer, 0, values);
      return buffer;
    });
    const result = this.bufferOf(size, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC);
    const readable = this.bufferOf(size, GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST);
    const entries = [...buffers, result].map((buffer, binding) => ({ binding, resource: { buffer } }));
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
    pass.dispatchWorkgroups(inputs[0].length / 64);
    pass.end();
    encoder.copyBufferToBuffer(result, 0, readable, 0, size);
    device.queue.submit([encoder.finish()]);
    const error = await device.popErrorScope();
    if (error) throw new Error(`Dawn refuses the WGSL of ${name}: ${error.message}`);
    await readable.mapAsync(GPUMapMode.READ);
    const values = new Float32Array(readable.getMappedRange().slice(0));
    for (const buffer of [...buffers, result, readable]) buffer.destroy();
    return values;
  }
}

module.exports = { Gpu };
