#include "bench/device/vulkan_device.hpp"

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <vulkan/vulkan_raii.hpp>

#include "fit/support/user_error.hpp"

namespace shadefit::device {
namespace {

constexpr std::uint32_t api = VK_API_VERSION_1_1;

/// Calls a function. An error of Vulkan becomes a CheckFailed with one line.
template <class F>
auto in_words(const F& function) -> decltype(function()) {
  try {
    return function();
  } catch (const vk::SystemError& error) {
    throw CheckFailed(fmt::format("the Vulkan driver fails: {}", error.what()));
  }
}

std::string version_text(std::uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

std::string kind_of(vk::PhysicalDeviceType type) {
  constexpr std::array names{"other", "integrated GPU", "discrete GPU", "virtual GPU", "CPU"};
  static_assert(names.size() == 1 + static_cast<std::size_t>(vk::PhysicalDeviceType::eCpu));
  const auto place = static_cast<std::size_t>(type);
  return names[place < names.size() ? place : 0];
}

/// The queue family that can compute, if there is one.
std::optional<std::uint32_t> compute_family(const vk::raii::PhysicalDevice& device) {
  const auto families = device.getQueueFamilyProperties();
  for (std::size_t i = 0; i < families.size(); ++i) {
    if (families[i].queueFlags & vk::QueueFlagBits::eCompute) return static_cast<std::uint32_t>(i);
  }
  return std::nullopt;
}

DeviceInfo info_of(const vk::raii::PhysicalDevice& device) {
  const auto chain =
      device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
  const auto& basic = chain.get<vk::PhysicalDeviceProperties2>().properties;
  const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
  const auto features =
      device.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceShaderFloat16Int8Features>();
  const std::string driver_name(driver.driverName.data()), driver_info(driver.driverInfo.data());
  DeviceInfo info;
  info.name = basic.deviceName.data();
  info.driver = driver_info.empty() ? fmt::format("{} {}", driver_name, version_text(basic.driverVersion))
                                    : fmt::format("{}, {}", driver_name, driver_info);
  info.vulkan = version_text(basic.apiVersion);
  info.kind = kind_of(basic.deviceType);
  info.has_half = features.get<vk::PhysicalDeviceShaderFloat16Int8Features>().shaderFloat16 == VK_TRUE;
  info.has_timestamps =
      device.getQueueFamilyProperties()[compute_family(device).value()].timestampValidBits > 0 &&
      basic.limits.timestampPeriod > 0;
  return info;
}

/// The loader with its instance.
struct Loader {
  vk::raii::Context context;
  vk::raii::Instance instance;

  Loader() : instance(make(context)) {}

  static vk::raii::Instance make(const vk::raii::Context& context) {
    const vk::ApplicationInfo application("shadefit", 0, nullptr, 0, api);
    return {context, vk::InstanceCreateInfo({}, &application)};
  }

  /// The devices that can compute and that know this version of Vulkan.
  std::vector<vk::raii::PhysicalDevice> devices() const {
    std::vector<vk::raii::PhysicalDevice> usable;
    for (vk::raii::PhysicalDevice& device : vk::raii::PhysicalDevices(instance)) {
      if (compute_family(device) && device.getProperties().apiVersion >= api)
        usable.push_back(std::move(device));
    }
    return usable;
  }
};

/// Opens the loader. Throws UserError without a loader or a driver.
std::unique_ptr<Loader> open_loader() {
  try {
    return std::make_unique<Loader>();
  } catch (const vk::SystemError& error) {
    throw UserError(fmt::format("no Vulkan driver answers: {}", error.what()));
  } catch (const std::runtime_error&) {
    throw UserError("the Vulkan loader is not installed: libvulkan.so.1 is missing");
  }
}

/// A buffer and its memory, mapped if this program can read it.
struct Buffer {
  vk::raii::Buffer buffer{nullptr};
  vk::raii::DeviceMemory memory{nullptr};
  std::span<float> words;
};

std::uint32_t memory_type(const vk::raii::PhysicalDevice& device, std::uint32_t allowed,
                          const std::vector<vk::MemoryPropertyFlags>& wishes) {
  const auto properties = device.getMemoryProperties();
  for (const vk::MemoryPropertyFlags wish : wishes) {
    for (std::uint32_t i = 0; i < properties.memoryTypeCount; ++i) {
      const bool is_allowed = (allowed >> i & 1U) != 0;
      if (is_allowed && (properties.memoryTypes[i].propertyFlags & wish) == wish) return i;
    }
  }
  throw CheckFailed("the Vulkan device has no memory for a buffer");
}

Buffer make_buffer(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device,
                   const DeviceChoice& choice) {
  using Property = vk::MemoryPropertyFlagBits;
  const vk::MemoryPropertyFlags visible = Property::eHostVisible | Property::eHostCoherent;
  const std::vector<vk::MemoryPropertyFlags> wishes =
      choice.has_buffers_on_device ? std::vector{vk::MemoryPropertyFlags(Property::eDeviceLocal)}
                                   : std::vector{visible | Property::eHostCached, visible};
  Buffer made;
  const vk::DeviceSize bytes = choice.words * sizeof(float);
  made.buffer = device.createBuffer({{}, bytes, vk::BufferUsageFlagBits::eStorageBuffer});
  const auto needs = made.buffer.getMemoryRequirements();
  made.memory = device.allocateMemory({needs.size, memory_type(physical, needs.memoryTypeBits, wishes)});
  made.buffer.bindMemory(*made.memory, 0);
  if (!choice.has_buffers_on_device)
    made.words = {static_cast<float*>(made.memory.mapMemory(0, bytes)), choice.words};
  return made;
}

vk::raii::Device make_device(const vk::raii::PhysicalDevice& physical, const DeviceInfo& info) {
  const float priority = 1;
  const vk::DeviceQueueCreateInfo queue({}, compute_family(physical).value(), 1, &priority);
  vk::PhysicalDeviceShaderFloat16Int8Features half(info.has_half);
  const char* const extension = VK_KHR_SHADER_FLOAT16_INT8_EXTENSION_NAME;
  vk::DeviceCreateInfo wanted({}, queue);
  if (info.has_half) wanted.setPNext(&half).setPEnabledExtensionNames(extension);
  return {physical, wanted};
}

vk::raii::DescriptorSetLayout make_set_layout(const vk::raii::Device& device) {
  std::array<vk::DescriptorSetLayoutBinding, 2> bindings;
  for (std::uint32_t i = 0; i < bindings.size(); ++i)
    bindings[i] = {i, vk::DescriptorType::eStorageBuffer, 1, vk::ShaderStageFlagBits::eCompute};
  return device.createDescriptorSetLayout({{}, bindings});
}

vk::raii::PipelineLayout make_layout(const vk::raii::Device& device,
                                     const vk::raii::DescriptorSetLayout& set) {
  const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, sizeof(PushWords));
  return device.createPipelineLayout({{}, *set, push});
}

}  // namespace

struct Program::Parts {
  vk::raii::ShaderModule module;
  vk::raii::Pipeline pipeline;
};

struct VulkanDevice::Parts {
  std::unique_ptr<Loader> loader;
  vk::raii::PhysicalDevice physical;
  DeviceInfo info;
  double seconds_per_tick;
  vk::raii::Device device;
  vk::raii::Queue queue;
  Buffer output, input;
  vk::raii::DescriptorSetLayout set_layout;
  vk::raii::PipelineLayout layout;
  vk::raii::DescriptorPool sets;
  vk::raii::DescriptorSet set{nullptr};
  vk::raii::QueryPool clock{nullptr};
  vk::raii::CommandPool pool;
  vk::raii::CommandBuffer commands{nullptr};

  explicit Parts(const DeviceChoice& choice)
      : loader(open_loader()),
        physical(chosen(choice.place)),
        info(info_of(physical)),
        seconds_per_tick(physical.getProperties().limits.timestampPeriod * 1e-9),
        device(make_device(physical, info)),
        queue(device.getQueue(family(), 0)),
        output(make_buffer(physical, device, choice)),
        input(make_buffer(physical, device, choice)),
        set_layout(make_set_layout(device)),
        layout(make_layout(device, set_layout)),
        sets(make_pool()),
        pool(device.createCommandPool({vk::CommandPoolCreateFlagBits::eResetCommandBuffer, family()})) {
    bind_buffers();
    if (info.has_timestamps) clock = device.createQueryPool({{}, vk::QueryType::eTimestamp, 2});
    commands = std::move(device.allocateCommandBuffers({*pool, vk::CommandBufferLevel::ePrimary, 1}).front());
  }

  vk::raii::PhysicalDevice chosen(std::size_t place) const {
    auto devices = loader->devices();
    if (place >= devices.size())
      throw UserError(fmt::format("--device 'vulkan:{}': this machine has {} device{} that can compute",
                                  place, devices.size(), devices.size() == 1 ? "" : "s"));
    return std::move(devices[place]);
  }

  std::uint32_t family() const { return compute_family(physical).value(); }

  vk::raii::DescriptorPool make_pool() const {
    const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer, 2);
    return device.createDescriptorPool({vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size});
  }

  void bind_buffers() {
    set = std::move(device.allocateDescriptorSets({*sets, *set_layout}).front());
    const std::array infos{vk::DescriptorBufferInfo(*output.buffer, 0, VK_WHOLE_SIZE),
                           vk::DescriptorBufferInfo(*input.buffer, 0, VK_WHOLE_SIZE)};
    for (std::uint32_t i = 0; i < infos.size(); ++i)
      device.updateDescriptorSets(
          vk::WriteDescriptorSet(*set, i, 0, vk::DescriptorType::eStorageBuffer, {}, infos[i]), {});
  }

  void record(const Program& program, std::uint32_t groups, const PushWords& push) const {
    using Stage = vk::PipelineStageFlagBits;
    commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *program.parts->pipeline);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout, 0, *set, {});
    commands.pushConstants<PushWords>(*layout, vk::ShaderStageFlagBits::eCompute, 0, push);
    if (info.has_timestamps) {
      commands.resetQueryPool(*clock, 0, 2);
      commands.writeTimestamp(Stage::eTopOfPipe, *clock, 0);
    }
    commands.dispatch(groups, 1, 1);
    if (info.has_timestamps) commands.writeTimestamp(Stage::eBottomOfPipe, *clock, 1);
    const vk::MemoryBarrier to_host(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead);
    commands.pipelineBarrier(Stage::eComputeShader, Stage::eHost, {}, to_host, {}, {});
    commands.end();
  }

  double run(const Program& program, std::uint32_t groups, const PushWords& push) const {
    // A driver has its own watchdog, which ends a dispatch much earlier.
    constexpr std::uint64_t patience = 60'000'000'000;  // nanoseconds
    record(program, groups, push);
    const vk::raii::Fence done = device.createFence({});
    const auto start = std::chrono::steady_clock::now();
    queue.submit(vk::SubmitInfo({}, {}, *commands), *done);
    if (device.waitForFences(*done, VK_TRUE, patience) != vk::Result::eSuccess)
      throw CheckFailed("the Vulkan device does not answer");
    const std::chrono::duration<double> outside = std::chrono::steady_clock::now() - start;
    if (!info.has_timestamps) return outside.count();
    const auto [result, ticks] =
        clock.getResults<std::uint64_t>(0, 2, 2 * sizeof(std::uint64_t), sizeof(std::uint64_t),
                                        vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
    return static_cast<double>(ticks[1] - ticks[0]) * seconds_per_tick;
  }
};

std::vector<DeviceInfo> vulkan_devices() {
  const auto loader = open_loader();
  return in_words([&] {
    std::vector<DeviceInfo> infos;
    for (const auto& device : loader->devices()) infos.push_back(info_of(device));
    return infos;
  });
}

VulkanDevice::VulkanDevice(const DeviceChoice& choice)
    : parts_(in_words([&] { return std::make_unique<Parts>(choice); })) {}
VulkanDevice::~VulkanDevice() = default;

const DeviceInfo& VulkanDevice::info() const {
  return parts_->info;
}

Program VulkanDevice::load(std::span<const std::uint32_t> spirv) const {
  return in_words([&] {
    const auto& device = parts_->device;
    vk::raii::ShaderModule module = device.createShaderModule({{}, spirv.size_bytes(), spirv.data()});
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main");
    vk::raii::Pipeline pipeline = device.createComputePipeline(nullptr, {{}, stage, *parts_->layout});
    return Program{
        std::make_shared<const Program::Parts>(Program::Parts{std::move(module), std::move(pipeline)})};
  });
}

double VulkanDevice::run(const Program& program, std::uint32_t threads, const PushWords& push) {
  if (threads > most_threads) throw std::logic_error("more threads than a dispatch has");
  const std::uint32_t groups = (threads + threads_per_group - 1) / threads_per_group;
  return in_words([&] { return parts_->run(program, groups, push); });
}

std::span<float> VulkanDevice::output() {
  return parts_->output.words;
}
std::span<float> VulkanDevice::input() {
  return parts_->input.words;
}

}  // namespace shadefit::device
