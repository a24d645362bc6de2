package org.phrenic.anatomy;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.phrenic.mesh.TriangleMesh;

/** Boxes that stand where the structures of a thorax do: LPS, mm, 300 mm wide. */
public final class BoxBody {
    private static final int[] BOX = {
        0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5
    };

    private BoxBody() {}

    public static List<Structure> structures() {
        List<Structure> list = new ArrayList<>();
        for (int level = 1; level <= 12; level++) {
            double z = 300 - 20 * level;
            add(list, String.format(Locale.ROOT, "rib_%02d_L", level), 140, 0, z);
            add(list, String.format(Locale.ROOT, "rib_%02d_R", level), -140, 0, z);
            add(list, String.format(Locale.ROOT, "vertebra_T%02d", level), 0, 90, z);
        }
        add(list, "sternum_body", 0, -90, 200);
        add(list, "diaphragm", 0, 0, 100);
        return list;
    }

    private static void add(List<Structure> list, String name, double x, double y, double z) {
        StructureName known = StructureName.parse(name).orElseThrow();
        list.add(new Structure(name, known.kind(), known.level(), known.side(), box(x, y, z, 10)));
    }

    public static TriangleMesh box(double x, double y, double z, double half) {
        double[] positions = new double[24];
        for (int corner = 0; corner < 8; corner++) {
            positions[3 * corner] = x + ((corner & 1) == 0 ? -half : half);
            positions[3 * corner + 1] = y + ((corner & 2) == 0 ? -half : half);
            positions[3 * corner + 2] = z + ((corner & 4) == 0 ? -half : half);
        }
        return new TriangleMesh(positions, BOX);
    }

    /** A structure on the other side of the midplane under the same name. */
    static Structure mirrored(Structure s) {
        double[] p = s.mesh().positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            p[i] = -p[i];
        }
        return s.withMesh(s.mesh().withPositions(p));
    }

    /** A body given in LPS as someone would give it who uses other axes and another unit. */
    static List<Structure> given(List<Structure> lps, String axes, double unitMm) {
        return lps.stream().map(s -> s.withMesh(given(s.mesh(), axes, unitMm))).toList();
    }

    private static TriangleMesh given(TriangleMesh lps, String axes, double unitMm) {
        double[] from = lps.positions();
        double[] to = new double[from.length];
        for (int i = 0; i < from.length; i += 3) {
            for (int axis = 0; axis < 3; axis++) {
                to[i + axis] = along(axes.charAt(axis), from, i) / unitMm;
            }
        }
        return lps.withPositions(to);
    }

    private static double along(char letter, double[] p, int i) {
        return switch (letter) {
            case 'L' -> p[i];
            case 'R' -> -p[i];
            case 'P' -> p[i + 1];
            case 'A' -> -p[i + 1];
            case 'S' -> p[i + 2];
            default -> -p[i + 2];
        };
    }
}
