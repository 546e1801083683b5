// Work whose least time is known: each step waits for the one before.

@group(0) @binding(0) var<storage, read_write> chains: array<u32>;
@group(0) @binding(1) var<uniform> turns: vec4u;

// A product and a sum; squaring keeps a compiler from folding steps together.
fn step(x: u32) -> u32 {
    return x * x + 1013904223u;
}

fn four_steps(x: u32) -> u32 {
    return step(step(step(step(x))));
}

fn sixteen_steps(x: u32) -> u32 {
    return four_steps(four_steps(four_steps(four_steps(x))));
}

fn sixty_four_steps(x: u32) -> u32 {
    return sixteen_steps(sixteen_steps(sixteen_steps(sixteen_steps(x))));
}

// 256 steps a turn, for lavapipe ends an invocation's loops after 65535 turns in all.
@compute @workgroup_size(64)
fn chain(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let i = group.x * 64u + lane;
    var x = chains[i];
    for (var k = 0u; k < turns.x; k++) {
        x = sixty_four_steps(sixty_four_steps(sixty_four_steps(sixty_four_steps(x))));
    }
    chains[i] = x;
}
