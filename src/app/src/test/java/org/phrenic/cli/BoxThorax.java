package org.phrenic.cli;

import java.nio.file.Path;
import java.util.Locale;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;

/** A folder of boxes that stand where the structures of a thorax do: LPS, 300 mm wide. */
final class BoxThorax {
    private static final int[] BOX = {
        0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5
    };

    private BoxThorax() {}

    /**
     * Writes it.
     *
     * @param left x of the left ribs: 140, or -140 for a mirrored body
     * @param scale units a millimetre
     */
    static Path write(Path folder, double left, double scale) {
        for (int level = 1; level <= 12; level++) {
            double z = 300 - 20 * level;
            save(folder, String.format(Locale.ROOT, "rib_%02d_L", level), left, 0, z, scale);
            save(folder, String.format(Locale.ROOT, "rib_%02d_R", level), -left, 0, z, scale);
            save(folder, String.format(Locale.ROOT, "vertebra_T%02d", level), 0, 90, z, scale);
        }
        save(folder, "sternum_body", 0, -90, 200, scale);
        save(folder, "diaphragm", 0, 0, 100, scale);
        return folder;
    }

    static void save(Path folder, String name, double x, double y, double z, double scale) {
        MeshFiles.write(folder.resolve(name + ".ply"), box(scale * x, scale * y, scale * z, scale * 10));
    }

    static TriangleMesh box(double x, double y, double z, double half) {
        double[] positions = new double[24];
        for (int corner = 0; corner < 8; corner++) {
            positions[3 * corner] = x + ((corner & 1) == 0 ? -half : half);
            positions[3 * corner + 1] = y + ((corner & 2) == 0 ? -half : half);
            positions[3 * corner + 2] = z + ((corner & 4) == 0 ? -half : half);
        }
        return new TriangleMesh(positions, BOX);
    }
}
