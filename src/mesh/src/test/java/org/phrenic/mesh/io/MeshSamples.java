package org.phrenic.mesh.io;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.phrenic.mesh.TriangleMesh;

/** Files that other programs wrote (see PROVENANCE.md beside them), and what is measured on a mesh. */
public final class MeshSamples {
    private MeshSamples() {}

    static byte[] bytes(String name) {
        try (InputStream in = MeshSamples.class.getResourceAsStream(name)) {
            return in.readAllBytes();
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    public static Path write(Path folder, String name, byte[] content) {
        try {
            return Files.write(folder.resolve(name), content);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    static Path write(Path folder, String name, String content) {
        return write(folder, name, content.getBytes(StandardCharsets.ISO_8859_1));
    }

    static TriangleMesh read(Path folder, String name) {
        return MeshFiles.read(write(folder, name, bytes(name)));
    }

    static double area(TriangleMesh mesh) {
        double sum = 0;
        for (int t = 0; t < mesh.triangleCount(); t++) {
            sum += Math.sqrt(square(cross(mesh, t))) / 2;
        }
        return sum;
    }

    /** Signed volume: positive if the triangles face outwards. */
    static double volume(TriangleMesh mesh) {
        double sum = 0;
        for (int t = 0; t < mesh.triangleCount(); t++) {
            int a = mesh.triangles()[3 * t];
            double[] n = cross(mesh, t);
            sum += (mesh.x(a) * n[0] + mesh.y(a) * n[1] + mesh.z(a) * n[2]) / 6;
        }
        return sum;
    }

    private static double square(double[] v) {
        return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    }

    private static double[] cross(TriangleMesh mesh, int t) {
        int a = mesh.triangles()[3 * t];
        int b = mesh.triangles()[3 * t + 1];
        int c = mesh.triangles()[3 * t + 2];
        double ux = mesh.x(b) - mesh.x(a);
        double uy = mesh.y(b) - mesh.y(a);
        double uz = mesh.z(b) - mesh.z(a);
        double vx = mesh.x(c) - mesh.x(a);
        double vy = mesh.y(c) - mesh.y(a);
        double vz = mesh.z(c) - mesh.z(a);
        return new double[] {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
    }

    /** A tetrahedron whose coordinates have no short decimal form. */
    static TriangleMesh tetrahedron() {
        return new TriangleMesh(
                new double[] {0, 0, 0, 1.0 / 3, 0, 0, 0, Math.PI, 0, 0, 0, -1e-7},
                new int[] {0, 1, 2, 0, 3, 1, 1, 3, 2, 0, 2, 3});
    }
}
