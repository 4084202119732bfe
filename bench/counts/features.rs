//! Prints what the processor offers, as detection at run time sees it: under valgrind that is less than there is.

fn main() {
    #[cfg(target_arch = "x86_64")]
    {
        let found = [
            ("sse4.2", is_x86_feature_detected!("sse4.2")),
            ("avx", is_x86_feature_detected!("avx")),
            ("avx2", is_x86_feature_detected!("avx2")),
            ("fma", is_x86_feature_detected!("fma")),
            ("bmi2", is_x86_feature_detected!("bmi2")),
            ("avx512f", is_x86_feature_detected!("avx512f")),
        ];
        let names: Vec<&str> = found.into_iter().filter(|f| f.1).map(|f| f.0).collect();
        println!("{} {}", std::env::consts::ARCH, names.join(" "));
    }
    #[cfg(not(target_arch = "x86_64"))]
    println!("{}", std::env::consts::ARCH);
}
