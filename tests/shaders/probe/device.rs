//! Runs probes on a graphics device, software included.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::sync::OnceLock;

use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::kernel::walk::STACK_LEN;
use brilliance_renderer::shaders::{Frame, ShaderModule, join};
use bytemuck::{Pod, cast_slice};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{BufferBindingType, BufferUsages, ErrorFilter};

use super::{Case, Probe, World};

const PROBE: ShaderModule = ShaderModule { name: "probe", source: include_str!("probe.wgsl") };
const WORKGROUP_SIZE: u32 = 64;
const RAY_BYTES: usize = 80;

const READ: BufferBindingType = BufferBindingType::Storage { read_only: true };
const WRITE: BufferBindingType = BufferBindingType::Storage { read_only: false };
/// What is bound, group by group.
const GROUPS: [&[BufferBindingType]; 3] =
    [&[READ; 10], &[READ, WRITE, WRITE], &[READ, READ, WRITE]];

/// One device for all tests. A machine without any fails the test rather than passing it unseen.
fn graphics() -> &'static Graphics {
    static GRAPHICS: OnceLock<Graphics> = OnceLock::new();
    GRAPHICS.get_or_init(|| {
        Graphics::open(true).unwrap_or_else(|error| {
            panic!(
                "these tests need a graphics device, be it software (mesa-vulkan-drivers): {error}"
            )
        })
    })
}

/// Does `work` on the device, which must find no fault with it.
fn guard<T>(work: impl FnOnce(&wgpu::Device) -> T) -> T {
    let device = graphics().device();
    let scope = device.push_error_scope(ErrorFilter::Validation);
    let made = work(device);
    if let Some(error) = pollster::block_on(scope.pop()) {
        panic!("{error}");
    }
    made
}

/// Probes, compiled; those that do the same are compiled once.
pub(super) struct Shader {
    layouts: Vec<wgpu::BindGroupLayout>,
    pipelines: HashMap<&'static str, wgpu::ComputePipeline>,
}

impl Shader {
    pub(super) fn new(modules: &[ShaderModule], probes: &[Probe]) -> Self {
        let source = wgpu::ShaderSource::Wgsl(source(modules, probes).into());
        guard(|device| {
            let layouts: Vec<_> = GROUPS.iter().map(|bindings| layout(device, bindings)).collect();
            let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: None,
                bind_group_layouts: &layouts.iter().map(Some).collect::<Vec<_>>(),
                immediate_size: 0,
            });
            let module =
                device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source });
            let pipeline = |probe: &Probe| {
                let descriptor = wgpu::ComputePipelineDescriptor {
                    label: Some(probe.name),
                    layout: Some(&pipeline_layout),
                    module: &module,
                    entry_point: Some(&entry_point(probe)),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    cache: None,
                };
                device.create_compute_pipeline(&descriptor)
            };
            let mut pipelines = HashMap::new();
            for probe in probes {
                pipelines.entry(probe.wgsl).or_insert_with(|| pipeline(probe));
            }
            Self { layouts, pipelines }
        })
    }

    /// Brings a world to where the probes read it.
    pub(super) fn load<'a>(&'a self, world: &'a World) -> LoadedWorld<'a> {
        let scene = &world.scene;
        let buffers = [
            storage(&scene.instances),
            storage(&scene.top_nodes),
            storage(&scene.words),
            storage(&scene.planes),
            storage(&scene.nodes),
            storage(&scene.triangles),
            storage(&scene.materials),
            storage(&scene.spectra),
            storage(&scene.discs),
            storage(&scene.passages),
        ];
        let group = self.group(0, &buffers);
        let World { scene, camera, size, rules, .. } = world;
        let mut frame = Frame::of(scene).seen(camera, *size, *rules);
        frame.pixel_count = size[0] * size[1];
        let frame = storage(&[frame]);
        LoadedWorld { shader: self, world, group, frame }
    }

    fn group(&self, number: usize, buffers: &[wgpu::Buffer]) -> wgpu::BindGroup {
        let entries: Vec<_> = (0..)
            .zip(buffers)
            .map(|(binding, buffer)| wgpu::BindGroupEntry {
                binding,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        guard(|device| {
            device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &self.layouts[number],
                entries: &entries,
            })
        })
    }
}

/// The kernel with one entry point per probe.
fn source(modules: &[ShaderModule], probes: &[Probe]) -> String {
    let mut source = join(&[modules, &[PROBE]].concat());
    for probe in probes {
        let (name, wgsl) = (entry_point(probe), probe.wgsl);
        let _ = write!(
            source,
            "
@compute @workgroup_size({WORKGROUP_SIZE})
fn {name}(@builtin(global_invocation_id) id: vec3u) {{
    if !begin_case(id.x) {{
        return;
    }}
    {wgsl}
    end_case();
}}
"
        );
    }
    source
}

fn entry_point(probe: &Probe) -> String {
    format!("probe_{}", probe.name.replace(' ', "_"))
}

fn layout(device: &wgpu::Device, bindings: &[BufferBindingType]) -> wgpu::BindGroupLayout {
    let entries: Vec<_> = (0..)
        .zip(bindings)
        .map(|(binding, &ty)| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None },
            count: None,
        })
        .collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: None,
        entries: &entries,
    })
}

/// An array that is read; an empty one as one zeroed element.
fn storage<T: Pod>(elements: &[T]) -> wgpu::Buffer {
    let zeroed = [T::zeroed()];
    let elements = if elements.is_empty() { &zeroed } else { elements };
    guard(|device| {
        device.create_buffer_init(&BufferInitDescriptor {
            label: None,
            contents: cast_slice(elements),
            usage: BufferUsages::STORAGE,
        })
    })
}

/// An array that is written to.
fn room(bytes: usize) -> wgpu::Buffer {
    guard(|device| {
        device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: bytes.max(RAY_BYTES) as u64,
            usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        })
    })
}

/// A world where the device reads it.
pub(super) struct LoadedWorld<'a> {
    shader: &'a Shader,
    world: &'a World,
    group: wgpu::BindGroup,
    frame: wgpu::Buffer,
}

impl LoadedWorld<'_> {
    /// What the probe puts for each case: how many words, and then the words, of which there is
    /// room for `output_len`.
    pub(super) fn run(&self, probe: &Probe, cases: &[Case], output_len: usize) -> Vec<Vec<u32>> {
        let input_len = cases.iter().map(|case| case.words().len()).max().unwrap_or(0);
        let mut inputs = vec![0; cases.len() * input_len];
        for (words, case) in inputs.chunks_exact_mut(input_len).zip(cases) {
            words[..case.words().len()].copy_from_slice(case.words());
        }
        let probing = [cases.len() as u32, input_len as u32, output_len as u32];
        let outputs = room(4 * cases.len() * (1 + output_len));
        let walkers = [
            self.frame.clone(),
            room(cases.len() * STACK_LEN * RAY_BYTES),
            room(4 * cases.len() * self.world.scene.bins.count()),
        ];
        let words = [storage(&probing), storage(&inputs), outputs.clone()];
        let walkers = self.shader.group(1, &walkers);
        let words = self.shader.group(2, &words);
        guard(|device| {
            let mut encoder =
                device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&self.shader.pipelines[probe.wgsl]);
            for (number, group) in (0..).zip([&self.group, &walkers, &words]) {
                pass.set_bind_group(number, group, &[]);
            }
            pass.dispatch_workgroups((cases.len() as u32).div_ceil(WORKGROUP_SIZE), 1, 1);
            drop(pass);
            graphics().queue().submit([encoder.finish()]);
        });
        let bytes = graphics().read_buffer(&outputs).unwrap_or_else(|error| panic!("{error}"));
        let words: Vec<u32> = bytemuck::pod_collect_to_vec(&bytes);
        words.chunks_exact(1 + output_len).map(<[u32]>::to_vec).collect()
    }
}
