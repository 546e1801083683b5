#![allow(missing_docs, clippy::all, clippy::unwrap_used, unreachable_pub, dead_code, reason = "temporary")]
#[path = "../tests/device/oracle.rs"]
mod oracle;
use oracle::*;
use glam::*;
use interreflect_gpu::*;
use interreflect_scene::*;
fn main() {
    let ctx = GpuContext::new(None).unwrap();
    let t = |name: &str, f: &mut dyn FnMut() -> GpuTime| {
        let mut gpu = vec![]; let mut wall = vec![];
        for _ in 0..15 { let s = std::time::Instant::now(); let g = f(); wall.push(s.elapsed().as_secs_f64()*1e3); gpu.push(g.ms); }
        let first = (gpu[0], wall[0]);
        gpu.sort_by(f64::total_cmp); wall.sort_by(f64::total_cmp);
        println!("{name}: gpu median {:.3} ms min {:.3}, wall median {:.3} ms; first gpu {:.1} wall {:.1}", gpu[7], gpu[0], wall[7], first.0, first.1);
    };
    t("empty record", &mut || ctx.record("e", |_| Ok::<_, GpuError>(())).unwrap().1);
    let mut scene = empty(Vec3::new(0.2, -0.1, 0.3));
    add_room(&mut scene, [0.7, 0.1, 0.6, 0.6, 0.2, 0.7].map(|a| Material::diffuse(Vec3::new(a, 0.5, 1.0 - a))));
    let spec = everything(256);
    let mut rd = spec; rd.channels.normal = false;
    let mut d = rd; d.channels.radiance = false;
    let s = GpuScene::new(&ctx, &scene).unwrap();
    t("256 all, no light", &mut || ctx.record("e", |cx| capture_cube(cx, &s, spec)).unwrap().1);
    t("256 distance only", &mut || ctx.record("e", |cx| capture_cube(cx, &s, d)).unwrap().1);
    let c = ctx.record("e", |cx| capture_cube(cx, &s, spec)).unwrap().0;
    let st = std::time::Instant::now(); let _ = c.download(&ctx).unwrap(); println!("download all {:.1} ms", st.elapsed().as_secs_f64()*1e3);
    let st = std::time::Instant::now(); let _ = c.download(&ctx).unwrap(); println!("download all {:.1} ms", st.elapsed().as_secs_f64()*1e3);
    let light = Light::Point { position: Vec3::new(0.0, 0.9, 0.0), intensity: Vec3::ONE };
    scene.lights.push(light);
    let s1 = GpuScene::new(&ctx, &scene).unwrap();
    t("256 all, 1 point light", &mut || ctx.record("e", |cx| capture_cube(cx, &s1, spec)).unwrap().1);
    t("256 radiance+distance, 1 point light", &mut || ctx.record("e", |cx| capture_cube(cx, &s1, rd)).unwrap().1);

    let run = |name: &str, scene: &Scene, size: u32| {
        let s1 = GpuScene::new(&ctx, &scene).unwrap();
        let (c, time) = ctx.record("e", |cx| capture_cube(cx, &s1, everything(size))).unwrap();
        let img = c.download(&ctx).unwrap();
        let light = scene.lights[0];
        let (mut fs, mut fl, mut other, mut dbad, mut n) = (0, 0, 0, 0, 0);
        let (mut sum, mut sumerr) = (0.0, 0.0);
        let (mut dmax, mut worst) = (0f64, 0f64);
        for (i, dir) in texels(size) {
            let Some(h) = first_hit(&scene, scene.reference_point.as_dvec3(), dir) else { continue };
            n += 1;
            let de = (f64::from(img.distance[i]) / h.distance - 1.0).abs();
            if de > 1e-4 { dbad += 1; continue; }
            dmax = dmax.max(de);
            let nn = if h.normal.dot(dir) < 0.0 { h.normal } else { -h.normal };
            let e = match light.incident(h.position.as_vec3()) { Some(inc) if nn.dot(inc.to_light.as_dvec3()) > 0.0 && reached(scene, &light, h.position, nn) =>
                h.material.albedo * inc.irradiance * (nn.as_vec3().dot(inc.to_light)) * std::f32::consts::FRAC_1_PI, _ => Vec3::ZERO };
            sum += e.y as f64; sumerr += (img.radiance[i].y - e.y).abs() as f64;
            if e == Vec3::ZERO && img.radiance[i] != Vec3::ZERO { fl += 1 }
            else if e != Vec3::ZERO && img.radiance[i] == Vec3::ZERO { fs += 1 }
            else if e != Vec3::ZERO { let r = ((img.radiance[i]-e).abs().max_element()/e.max_element()) as f64; if r > 1e-3 { other += 1 } else { worst = worst.max(r) } }
        }
        println!("{name}: {:.1} ms, of {n}: false shadow {fs}, false light {fl}, other>1e-3 {other}, rest max rel {worst:.1e}; distance>1e-4 {dbad}, rest {dmax:.1e}; L1 radiance {:.2e}", time.ms, sumerr/sum);
    };
    for p in [Vec3::new(0.0, 0.9, 0.0), Vec3::new(0.0, 0.99, 0.0), Vec3::new(0.0, 0.999, 0.0), Vec3::new(0.9, 0.9, 0.9), Vec3::new(0.1,-0.2,0.3)] {
        scene.lights = vec![Light::Point { position: p, intensity: Vec3::ONE }];
        run(&format!("box light {p}"), &scene, 256);
    }
    // with a sphere
    let (nu, nv) = (32u32, 16u32);
    let mut pos = vec![]; let mut tri = vec![];
    for v in 0..=nv { for u in 0..nu {
        let (th, ph) = (v as f32 / nv as f32 * std::f32::consts::PI, u as f32 / nu as f32 * std::f32::consts::TAU);
        pos.push(Vec3::new(th.sin()*ph.cos(), th.cos(), th.sin()*ph.sin()) * 0.3 + Vec3::new(-0.3, 0.0, -0.3));
    }}
    for v in 0..nv { for u in 0..nu { let a = v*nu+u; let b = v*nu+(u+1)%nu; let c = a+nu; let d = b+nu; tri.push([a,b,c]); tri.push([b,d,c]); } }
    let n = tri.len();
    scene.objects.push(Object { name: "s".into(), role: Role::Environment, mesh: Mesh { positions: pos, normals: vec![], triangles: tri, materials: vec![0; n] } });
    for l in [Light::Point { position: Vec3::new(0.0,0.9,0.0), intensity: Vec3::ONE }, Light::Directional { direction: Vec3::new(0.3,-1.0,0.2).normalize(), irradiance: Vec3::ONE }] {
        scene.lights = vec![l];
        if matches!(l, Light::Directional{..}) { scene.objects.remove(2); }
        run(&format!("sphere {l:?}"), &scene, 64);
    }
}
