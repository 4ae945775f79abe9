"""The generator and the instruments of the benchmarks, against closed forms."""

import math
import random
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))

import bed_figures
import mechanics
import particles
import scenes
import settled_bed
from packing import Cylinder
from parameters import RADII, counts, length_scale
from particles import Particle


class Generator(unittest.TestCase):
    def test_one_kilogram_of_each_kind_at_full_size(self):
        beads, granules = counts(193132)
        self.assertEqual((beads, granules), (19363, 173769))
        self.assertAlmostEqual(beads * Particle(1, RADII[0], (0, 0, 0)).mass, 1.0, places=4)
        self.assertAlmostEqual(granules * Particle(2, RADII[1], (0, 0, 0)).mass, 1.0, places=4)

    def test_a_loose_column_has_no_overlaps_and_stays_inside(self):
        radius = 0.05 * length_scale(600)
        column = scenes.loose_column(600, radius, 1.0, seed=7)
        self.assertEqual(len(column), 600)
        self.assertEqual(bed_figures.contacts(column), 0)
        height = scenes.loose_height(600, radius)
        for p in column:
            self.assertLessEqual(math.hypot(*p.position[:2]) + p.radius, radius)
            self.assertGreaterEqual(p.position[2] - p.radius, 0.0)
            self.assertLessEqual(p.position[2] + p.radius, height + 2 * scenes.CLEARANCE)

    def test_grains_on_the_chute_touch_neither_it_nor_each_other(self):
        layer = scenes.sliding_layer(2400, seed=3)
        foot_x, foot_z = scenes.chute_profile(length_scale(2400))[len(scenes.LIP_ANGLES)]
        sin, cos = math.sin(scenes.RAMP_ANGLE), math.cos(scenes.RAMP_ANGLE)
        for p in layer:
            off = (p.position[2] - foot_z) * cos - (p.position[0] - foot_x) * sin
            self.assertGreater(off, p.radius)
        self.assertEqual(bed_figures.contacts(layer), 0)

    def test_a_tilt_of_one_half_shifts_the_mean_by_a_twelfth_of_the_height(self):
        # mean of h with the density 1 + t (2 h - 1) on [0, 1]: 1/2 + t/6
        rng, region = random.Random(1), Cylinder(1.0, 0.0, 1.0, 0.5)
        mean = sum(region.sample(rng, 0.0)[2] for _ in range(10000)) / 10000
        self.assertAlmostEqual(mean, 0.5 + 0.5 / 6, delta=4 * 0.29 / 100)

    def test_a_dump_gives_back_every_bit(self):
        column = scenes.loose_column(200, 0.004, 0.1, seed=1)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "particles.dump"
            particles.write_dump(file, column, scenes.cylinder(200, 0.004).box)
            self.assertEqual(particles.read_dump(file), column)


class Instruments(unittest.TestCase):
    def cubic(self, n: int, spacing: float) -> list:
        radius = RADII[1]
        return [Particle(2, radius, (i * spacing, j * spacing, radius + k * spacing))
                for i in range(n) for j in range(n) for k in range(n)]

    def test_a_cubic_lattice_has_three_contacts_a_sphere_but_for_its_faces(self):
        diameter = 2 * RADII[1]
        self.assertEqual(bed_figures.contacts(self.cubic(6, 0.999 * diameter)), 3 * 6 * 6 * 5)
        self.assertEqual(bed_figures.contacts(self.cubic(6, 1.001 * diameter)), 0)

    def test_a_cubic_lattice_fills_pi_over_six(self):
        diameter, n = 2 * RADII[1], 16
        radius = n * diameter / math.sqrt(math.pi)  # of the circle with the lattice's area
        found = bed_figures.solid_fraction(self.cubic(n, diameter), radius)
        self.assertAlmostEqual(found, math.pi / 6, delta=0.01)

    def test_each_layer_has_the_mass_ratio_of_its_grains(self):
        # Nine granules are as heavy as a bead to 0.3 %: 10 beads and 90 granules, or 5 and 135.
        contents = [(10, 90), (5, 135), (10, 90), (10, 90), (5, 135)]
        bed = []
        for layer, (beads, granules) in enumerate(contents):
            bed += [Particle(1, RADII[0], (0, 0, -layer - 0.5)) for _ in range(beads)]
            bed += [Particle(2, RADII[1], (0, 0, -layer - k / granules)) for k in range(granules)]
        one_granule = 1 / 90
        for found, (beads, granules) in zip(bed_figures.mass_ratios(bed), contents):
            wanted = beads * bed[0].mass / (granules * bed[-1].mass)
            self.assertAlmostEqual(found / wanted, 1.0, delta=2 * one_granule)

    def test_the_height_leaves_out_one_per_cent_of_the_mass(self):
        bed = [Particle(2, RADII[1], (0, 0, 0.001 * k)) for k in range(200)]
        self.assertAlmostEqual(bed_figures.height(bed), 0.197 + RADII[1])


class Driver(unittest.TestCase):
    def row(self, code, speed, state_hash=""):
        return {"scenario": "settled", "particles": "3862", "cores": "1", "code": code,
                "particle_steps_per_second": speed, "state_hash": state_hash}

    def test_the_table_holds_medians_and_their_ratio(self):
        rows = [self.row("pmr", s) for s in (4e6, 6e6, 90e6)]
        rows += [self.row("liggghts", s) for s in (1e6, 3e6, 5e6)]
        self.assertEqual(mechanics.speeds_by_code(rows).splitlines()[1].split(),
                         ["settled", "3862", "1", "6.00", "3.00", "2.00"])

    def test_differing_hashes_are_noticed(self):
        rows = [self.row("pmr", 1e6, "a"), self.row("pmr", 1e6, "a")]
        self.assertEqual(mechanics.differing_hashes(rows), [])
        rows.append(self.row("pmr", 1e6, "b"))
        self.assertEqual(mechanics.differing_hashes(rows), [("settled", "3862")])

    def test_a_shift_beyond_the_scatter_is_noticed(self):
        def rows(shift):
            return [{"code": code, **{n: 1.0 + 0.01 * seed + (shift if code == "pmr" else 0.0)
                                      for n in settled_bed.FIGURES}}
                    for seed in range(3) for code in settled_bed.CODES]
        self.assertTrue(all(f.is_within_scatter() for f in settled_bed.compare(rows(0.01))))
        self.assertFalse(any(f.is_within_scatter() for f in settled_bed.compare(rows(0.1))))


if __name__ == "__main__":
    unittest.main()
