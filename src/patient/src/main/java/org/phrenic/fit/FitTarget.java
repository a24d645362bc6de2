package org.phrenic.fit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.document.CsvTable;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.file.Hashes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshRepair;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.patient.registration.DiaphragmaticSurface;

/**
 * Position of a part of the body at the second breath level, given as a surface or as point pairs. Coordinates are in
 * the axes of the body, mm.
 *
 * @param surface target surface; null for point pairs
 * @param from points on or near the part at end-expiration, as x, y, z triples; empty for a surface
 * @param to the same points at the second breath level
 * @param weight weight relative to other targets; 0 if the target is only reported
 */
public record FitTarget(String name, FitPart part, TriangleMesh surface, double[] from, double[] to, double weight) {
    static final String[] FROM = {"x_mm", "y_mm", "z_mm"};
    static final String[] TO = {"to_x_mm", "to_y_mm", "to_z_mm"};

    public FitTarget {
        if (from.length != to.length || from.length % 3 != 0) {
            throw new IllegalArgumentException(
                    name + ": found " + from.length + " and " + to.length + " coordinates, expected pairs of points");
        }
        if (surface == null == (from.length == 0)) {
            throw new IllegalArgumentException(name + ": expected a surface or pairs of points");
        }
        if (!(weight >= 0)) {
            throw new IllegalArgumentException(name + ": found weight " + weight + ", expected 0 or more");
        }
        from = from.clone();
        to = to.clone();
    }

    /** Returns a surface target with weight 1. */
    public static FitTarget of(FitPart part, TriangleMesh surface) {
        return new FitTarget(part.label(), part, surface, new double[0], new double[0], 1);
    }

    /** Returns a point pair target with weight 1. */
    public static FitTarget ofPointPairs(FitPart part, double[] from, double[] to) {
        return new FitTarget(part.label() + "_points", part, null, from, to, 1);
    }

    /** Returns a copy with another weight. */
    public FitTarget withWeight(double other) {
        return new FitTarget(name, part, surface, from, to, other);
    }

    /**
     * Adds the base of each lung as a target of the same weight, unless it is already present. The base is a small part
     * of the lung surface, but only the base shows the dome of the diaphragm. Both lungs in one surface bring none.
     */
    public static List<FitTarget> withBases(List<FitTarget> targets) {
        List<FitTarget> all = new ArrayList<>();
        for (FitTarget target : targets) {
            all.add(target);
            FitPart base = target.isPointPairs() ? null : target.part().base();
            if (base != null
                    && DiaphragmaticSurface.of(target.surface).triangleCount() > 0
                    && targets.stream().noneMatch(t -> t.part() == base)) {
                all.add(of(base, target.surface).withWeight(target.weight));
            }
        }
        return all;
    }

    /** A sentence on each surface of both lungs in one, which brings no base, unless a base is a target too. */
    static List<String> withoutBase(List<FitTarget> targets) {
        boolean bases = targets.stream().anyMatch(target -> target.part().isBase());
        return targets.stream()
                .filter(target -> !bases && target.weight() > 0)
                .filter(target -> target.part() == FitPart.LUNGS && !target.isPointPairs())
                .map(target -> "The target " + target.name() + " has no base of its own, which "
                        + FitPart.LUNG_RIGHT.label() + " and " + FitPart.LUNG_LEFT.label()
                        + " have: the domes may be millimetres wrong.")
                .toList();
    }

    /** Whether the target consists of point pairs. */
    public boolean isPointPairs() {
        return surface == null;
    }

    /** A text that two targets share only if a search finds no difference between them. */
    String content() {
        String place = isPointPairs()
                ? Hashes.sha256(from, to)
                : Hashes.sha256(surface.positions()) + ' ' + Hashes.sha256(surface.triangles());
        return name + ' ' + part + ' ' + weight + ' ' + place;
    }

    /**
     * Reads a target given as {@code PART=FILE}, or as {@code FILE} if the file name without extension is a part. A CSV
     * file contains point pairs in the columns x_mm, y_mm, z_mm, to_x_mm, to_y_mm, to_z_mm. A surface is repaired as
     * those of a body are ({@link ThoraxFolder}).
     *
     * @throws BadInputException if the text or the file is invalid
     */
    public static FitTarget read(String text) {
        int equals = text.indexOf('=');
        Path file = Path.of(text.substring(equals + 1));
        String label = equals > 0 ? text.substring(0, equals) : FileNames.withoutExtension(file);
        FitPart part = FitPart.of(label)
                .orElseThrow(() -> new BadInputException("--target " + text + ": found part '" + label
                        + "', expected PART=FILE with one of " + FitPart.labels()));
        if (text.toLowerCase(Locale.ROOT).endsWith(".csv")) {
            CsvTable table = CsvTable.read(file);
            if (table.rowCount() == 0) {
                throw new BadInputException(file + ": found no row, expected pairs of points");
            }
            return ofPointPairs(part, points(table, FROM), points(table, TO));
        }
        TriangleMesh read = MeshFiles.read(file);
        ThoraxFolder.requireSize(file.toString(), read, "");
        TriangleMesh mesh = MeshRepair.repair(read, ThoraxFolder.WELD_MM, ThoraxFolder.SEAM_MM)
                .mesh();
        if (mesh.triangleCount() == 0) {
            throw new BadInputException(file + ": found no triangle with an area, expected a surface");
        }
        return of(part, mesh);
    }

    static double[] points(CsvTable table, String[] columns) {
        double[] out = new double[3 * table.rowCount()];
        for (int axis = 0; axis < 3; axis++) {
            double[] column = table.numbers(columns[axis]);
            for (int i = 0; i < column.length; i++) {
                out[3 * i + axis] = column[i];
            }
        }
        return out;
    }
}
