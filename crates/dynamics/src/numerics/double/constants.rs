//! Constants of double-double arithmetic, printed by `tests/references/double_constants.py`.

use super::Dd;

pub(crate) const PI: Dd = Dd::from_bits(0x4009_21fb_5444_2d18, 0x3ca1_a626_3314_5c07);
pub(crate) const TAU: Dd = Dd::from_bits(0x4019_21fb_5444_2d18, 0x3cb1_a626_3314_5c07);
pub(crate) const FRAC_PI_2: Dd = Dd::from_bits(0x3ff9_21fb_5444_2d18, 0x3c91_a626_3314_5c07);
pub(crate) const FRAC_PI_4: Dd = Dd::from_bits(0x3fe9_21fb_5444_2d18, 0x3c81_a626_3314_5c07);
pub(crate) const E: Dd = Dd::from_bits(0x4005_bf0a_8b14_5769, 0x3ca4_d57e_e2b1_013a);
pub(crate) const LN_2: Dd = Dd::from_bits(0x3fe6_2e42_fefa_39ef, 0x3c7a_bc9e_3b39_803f);
pub(crate) const LN_10: Dd = Dd::from_bits(0x4002_6bb1_bbb5_5516, 0xbcaf_48ad_494e_a3e9);
pub(crate) const SQRT_2: Dd = Dd::from_bits(0x3ff6_a09e_667f_3bcd, 0xbc9b_dd34_13b2_6456);

/// The two leading parts of ln 2 with 40 bits each: their products with an exponent are exact.
pub(crate) const LN_2_PARTS: [f64; 2] = [
    f64::from_bits(0x3fe6_2e42_fefa_2000),
    f64::from_bits(0x3d69_ef35_793c_6000),
];

/// What the two parts leave of ln 2.
pub(crate) const LN_2_REST: Dd = Dd::from_bits(0x3ae6_7300_7e5e_d5e8, 0x376e_6864_ce53_16c6);

/// The reciprocals of the factorials, 1/n! for n = 0, 1, ..., 30.
pub(crate) const INVERSE_FACTORIALS: [Dd; 31] = [
    Dd::from_bits(0x3ff0_0000_0000_0000, 0x0000_0000_0000_0000),
    Dd::from_bits(0x3ff0_0000_0000_0000, 0x0000_0000_0000_0000),
    Dd::from_bits(0x3fe0_0000_0000_0000, 0x0000_0000_0000_0000),
    Dd::from_bits(0x3fc5_5555_5555_5555, 0x3c65_5555_5555_5555),
    Dd::from_bits(0x3fa5_5555_5555_5555, 0x3c45_5555_5555_5555),
    Dd::from_bits(0x3f81_1111_1111_1111, 0x3c01_1111_1111_1111),
    Dd::from_bits(0x3f56_c16c_16c1_6c17, 0xbbef_49f4_9f49_f49f),
    Dd::from_bits(0x3f2a_01a0_1a01_a01a, 0x3b6a_01a0_1a01_a01a),
    Dd::from_bits(0x3efa_01a0_1a01_a01a, 0x3b3a_01a0_1a01_a01a),
    Dd::from_bits(0x3ec7_1de3_a556_c734, 0xbb6c_154f_8ddc_6c00),
    Dd::from_bits(0x3e92_7e4f_b778_9f5c, 0x3b3c_bbc0_5b4f_a99a),
    Dd::from_bits(0x3e5a_e645_67f5_44e4, 0xbafc_062e_06d1_f209),
    Dd::from_bits(0x3e21_eed8_eff8_d898, 0xbac2_aec9_59e1_4c06),
    Dd::from_bits(0x3de6_1246_13a8_6d09, 0x3a8f_28e0_cc74_8ebe),
    Dd::from_bits(0x3da9_3974_a8c0_7c9d, 0x3a30_5d6f_8a2e_fd1f),
    Dd::from_bits(0x3d6a_e7f3_e733_b81f, 0x39e1_d865_6b0e_e8cb),
    Dd::from_bits(0x3d2a_e7f3_e733_b81f, 0x39a1_d865_6b0e_e8cb),
    Dd::from_bits(0x3ce9_52c7_7030_ad4a, 0x398a_c981_465d_dc6c),
    Dd::from_bits(0x3ca6_8278_63b9_7d97, 0x394e_ec01_221a_8b0b),
    Dd::from_bits(0x3c62_f49b_4681_4157, 0x38f2_650f_61db_dcb4),
    Dd::from_bits(0x3c1e_542b_a402_0225, 0x387e_a72b_4afe_3c2f),
    Dd::from_bits(0x3bd7_1b8e_f6dc_f572, 0xb87d_043a_e40c_4647),
    Dd::from_bits(0x3b90_ce39_6db7_f853, 0xb83a_ebcd_bd20_331c),
    Dd::from_bits(0x3b47_61b4_1316_381a, 0xb7d3_423c_7d91_404f),
    Dd::from_bits(0x3aff_2cf0_1972_f578, 0xb789_ada5_fcc1_ab14),
    Dd::from_bits(0x3ab3_f3cc_dd16_5fa9, 0xb745_8dda_df34_4487),
    Dd::from_bits(0x3a68_8e85_fc6a_4e5a, 0xb707_1c37_ebd1_6540),
    Dd::from_bits(0x3a1d_1ab1_c2dc_cea3, 0x36a0_54d0_c78a_ea14),
    Dd::from_bits(0x39d0_a18a_2635_085d, 0x366b_9e2e_28e1_aa54),
    Dd::from_bits(0x3982_59f9_8b43_58ad, 0x362e_af8c_39dd_9bc5),
    Dd::from_bits(0x3933_932c_5047_d60e, 0x35d8_32b7_b530_a627),
];

/// Where zero stands in the table of exponentials.
pub(crate) const EXPM1_OF_32NDS_CENTRE: f64 = 12.0;

/// e^(j/32) - 1 for j = -12, -11, ..., 12.
pub(crate) const EXPM1_OF_32NDS: [Dd; 25] = [
    Dd::from_bits(0xbfd4_0373_d42c_e2e3, 0x3c75_3d8d_b804_c224),
    Dd::from_bits(0xbfd2_9e01_1a42_8ec6, 0xbc6d_abf5_975c_0c02),
    Dd::from_bits(0xbfd1_2d35_a41b_a104, 0x3c63_445f_7544_e0ef),
    Dd::from_bits(0xbfcf_616a_79dd_a3a8, 0xbc66_b2ea_b630_20c1),
    Dd::from_bits(0xbfcc_5041_854d_f7d4, 0xbc67_97d4_686c_5393),
    Dd::from_bits(0xbfc9_262c_1c34_30a1, 0xbc64_6ff6_ec4a_4251),
    Dd::from_bits(0xbfc5_e25f_b4fd_e211, 0x3c06_4eec_8291_5df3),
    Dd::from_bits(0xbfc2_840b_5836_cf67, 0xbc68_5405_051e_b425),
    Dd::from_bits(0xbfbe_14ae_d893_eef4, 0x3c4e_1f58_934f_97af),
    Dd::from_bits(0xbfb6_e8ca_ff34_1fea, 0xbc59_573d_ed78_88b2),
    Dd::from_bits(0xbfaf_0540_438f_d5c3, 0xbc2a_1ce0_1f9f_6ca7),
    Dd::from_bits(0xbf9f_8152_aee9_450e, 0x3c24_b00a_bf97_7627),
    Dd::from_bits(0x0000_0000_0000_0000, 0x0000_0000_0000_0000),
    Dd::from_bits(0x3fa0_40ac_0224_fd93, 0x3c2c_17a1_0757_5019),
    Dd::from_bits(0x3fb0_82b5_77d3_4ed8, 0xbc45_272f_f30e_ed1b),
    Dd::from_bits(0x3fb9_2937_074e_0cd7, 0xbc5d_b0b9_cc91_5fc5),
    Dd::from_bits(0x3fc1_0b02_2db7_ae68, 0xbc58_c4a5_df1e_c7e5),
    Dd::from_bits(0x3fc5_a5ac_59b9_63cb, 0xbc6f_d913_07e7_4c50),
    Dd::from_bits(0x3fca_65c0_b85a_c1a9, 0x3c6a_9c18_9196_f8cd),
    Dd::from_bits(0x3fcf_4c6f_5508_ee5d, 0x3c64_6ef7_b808_180a),
    Dd::from_bits(0x3fd2_2d78_f0fa_061a, 0xbc78_9843_c496_4554),
    Dd::from_bits(0x3fd4_c946_033e_b3de, 0xbc73_5d26_7d66_dc96),
    Dd::from_bits(0x3fd7_7a45_d811_7fd5, 0xbc52_bb36_e6b3_a2af),
    Dd::from_bits(0x3fda_4124_b2fe_50cb, 0x3c6f_b5f3_020a_46f5),
    Dd::from_bits(0x3fdd_1e94_4f6f_bdaa, 0xbc7d_cb87_49a6_4f6e),
];

/// The binary fraction of 2/π, 64 bits a word, the leading word first.
pub(crate) const TWO_OVER_PI: [u64; 23] = [
    0xa2f9_836e_4e44_1529,
    0xfc27_57d1_f534_ddc0,
    0xdb62_9599_3c43_9041,
    0xfe51_63ab_debb_c561,
    0xb724_6e3a_424d_d2e0,
    0x0649_2eea_09d1_921c,
    0xfe1d_eb1c_b129_a73e,
    0xe882_35f5_2ebb_4484,
    0xe99c_7026_b45f_7e41,
    0x3991_d639_8353_39f4,
    0x9c84_5f8b_bdf9_283b,
    0x1ff8_97ff_de05_980f,
    0xef2f_118b_5a0a_6d1f,
    0x6d36_7ecf_27cb_09b7,
    0x4f46_3f66_9e5f_ea2d,
    0x7527_bac7_ebe5_f17b,
    0x3d07_39f7_8a52_92ea,
    0x6bfb_5fb1_1f8d_5d08,
    0x5603_3046_fc7b_6bab,
    0xf0cf_bc20_9af4_361d,
    0xa9e3_9161_5ee6_1b08,
    0x6599_855f_14a0_6840,
    0x8dff_d880_4d73_2731,
];
