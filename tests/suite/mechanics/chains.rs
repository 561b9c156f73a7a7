//! Forces that are given by quantities, which are given by others.

use vibank::answer::Verdict;
use vibank::bank::Catalogue;
use vibank::grade::mark;
use vibank::instance::Instance;
use vibank::solution::Solution;

/// Each quantity is the one before; the force of the model is the last of them.
fn chained(levels: usize) -> String {
    let chain: String = (1..=levels)
        .map(|level| {
            format!(
                "f{level} = {{ formula = \"f{}\", unit = \"N\" }}\n",
                level - 1
            )
        })
        .collect();
    format!(
        "[item]\ntitle = \"Chain\"\nsource = \"by hand\"\ntopics = [\"forced vibration\"]\nlevel = 1\n\
         [parameters]\n\
         m = {{ name = \"mass\", value = \"2 kg\" }}\n\
         k = {{ name = \"stiffness\", value = \"50 N/m\" }}\n\
         F = {{ name = \"force\", value = \"3 N\" }}\n\
         Omega = {{ name = \"angular frequency\", value = \"3 rad/s\" }}\n\
         [model]\n\
         coordinates = {{ x = {{ name = \"displacement\", unit = \"m\" }} }}\n\
         kinetic = \"1/2*m*x'^2\"\npotential = \"1/2*k*x^2\"\nforces = {{ x = \"f{levels}\" }}\n\
         [quantities]\nf0 = {{ formula = \"F*cos(Omega*t)\", unit = \"N\" }}\n{chain}\
         X = {{ formula = \"abs(model.complex_amplitude)\", unit = \"m\" }}\n\
         [statement]\ntext = \"A block << m.given >>, << k.given >>, << F.given >>, << Omega.given >>.\"\n\
         [[part]]\nkey = \"X\"\nask = \"How far does it swing?\"\n"
    )
}

#[test]
fn a_force_may_be_a_chain_of_functions_of_any_length() {
    for levels in [1, 9, 30] {
        let item = chained(levels);
        let (catalogue, findings) = Catalogue::load([
            (
                "bank.toml",
                "format = 1\ntitle = 'Test'\n[topics]\n'forced vibration' = 'Forced'\n",
            ),
            ("free/_chapter.toml", "title = 'Free'\n"),
            ("free/chain.toml", item.as_str()),
        ]);
        let template = catalogue.find("free/chain");
        let template = template.unwrap_or_else(|| panic!("{levels}: {findings:#?}"));
        let solution = Solution::of(Instance::of_source(template));
        // F/(k - m Ω²) = 3/32 m.
        assert_eq!(
            mark(&solution, 0, "0.09375 m").verdict,
            Verdict::Right,
            "{levels}"
        );
        assert_eq!(
            mark(&solution, 0, "0.06 m").verdict,
            Verdict::Wrong,
            "{levels}"
        );
    }
}
