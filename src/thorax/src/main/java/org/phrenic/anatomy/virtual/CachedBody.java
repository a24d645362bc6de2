package org.phrenic.anatomy.virtual;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.EntryContent;
import org.phrenic.file.UserCache;
import org.phrenic.mesh.TriangleMesh;

/**
 * Generated bodies in a cache, bit for bit. An entry holds the name of the body, the number of structures, and of each
 * structure its name, kind, level, side, number of coordinates and corners, coordinates (float64) and corners (int32).
 * A text is an int32 length and UTF-8.
 */
final class CachedBody {
    private static final String KIND = "body";

    private CachedBody() {}

    /** The body of a key from the cache, or else the generated one, which is then kept. */
    static Thorax in(UserCache cache, String key, Supplier<Thorax> generated) {
        Optional<Thorax> known = read(cache, key);
        if (known.isPresent()) {
            return known.get();
        }
        Thorax thorax = generated.get();
        if (!cache.isOff()) {
            cache.write(KIND, key, write(thorax));
        }
        return thorax;
    }

    /** The body of a key; empty if the cache does not hold it. */
    static Optional<Thorax> read(UserCache cache, String key) {
        return cache.read(KIND, key).flatMap(CachedBody::read);
    }

    private static ByteBuffer write(Thorax thorax) {
        int size = EntryContent.size(thorax.name()) + Integer.BYTES;
        for (Structure s : thorax.structures()) {
            size += EntryContent.size(s.name()) + EntryContent.size(s.kind().name());
            size += EntryContent.size(s.side().name()) + 3 * Integer.BYTES;
            size += Double.BYTES * s.mesh().positions().length
                    + Integer.BYTES * s.mesh().triangles().length;
        }
        ByteBuffer out = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
        EntryContent.put(out, thorax.name());
        out.putInt(thorax.structures().size());
        for (Structure s : thorax.structures()) {
            EntryContent.put(out, s.name());
            EntryContent.put(out, s.kind().name());
            out.putInt(s.level());
            EntryContent.put(out, s.side().name());
            double[] positions = s.mesh().positions();
            int[] triangles = s.mesh().triangles();
            out.putInt(positions.length).putInt(triangles.length);
            EntryContent.put(out, positions);
            out.asIntBuffer().put(triangles);
            out.position(out.position() + Integer.BYTES * triangles.length);
        }
        return out.flip();
    }

    private static Optional<Thorax> read(ByteBuffer in) {
        try {
            String name = EntryContent.text(in);
            int count = in.getInt();
            List<Structure> structures = new ArrayList<>(count);
            for (int i = 0; i < count; i++) {
                String structure = EntryContent.text(in);
                StructureKind kind = StructureKind.valueOf(EntryContent.text(in));
                int level = in.getInt();
                Side side = Side.valueOf(EntryContent.text(in));
                int coordinates = in.getInt();
                int[] triangles = new int[in.getInt()];
                double[] positions = EntryContent.numbers(in, coordinates);
                in.asIntBuffer().get(triangles);
                in.position(in.position() + Integer.BYTES * triangles.length);
                structures.add(new Structure(structure, kind, level, side, new TriangleMesh(positions, triangles)));
            }
            return Optional.of(new Thorax(name, structures, List.of()));
        } catch (BufferUnderflowException | IllegalArgumentException | NegativeArraySizeException e) {
            return Optional.empty();
        }
    }
}
