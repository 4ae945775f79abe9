#!/usr/bin/env python3
"""Writes the inputs of both codes: particles, walls, case of pmr, deck of LIGGGHTS."""

import arguments
import scenarios


def main() -> None:
    parser = arguments.parser(__doc__)
    arguments.add_choice(parser)
    options = parser.parse_args()
    arguments.check_choice(parser, options)
    for name, particles in arguments.chosen(options):
        inputs = scenarios.prepare(options.work, name, particles)
        (inputs.folder / "in.liggghts").write_text(inputs.deck(1))
        print(inputs.folder, flush=True)


if __name__ == "__main__":
    main()
