package org.phrenic.mesh.io.dicom;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/** Elements of a DICOM file, or of an item of a sequence. Values are decoded when they are asked for. */
public final class DicomDataSet {
    private final DicomBytes bytes;
    private final Map<Integer, DicomElement> elements = new HashMap<>();
    private final Charset charset;
    private final int depth;

    /** The elements from {@code from} to {@code to}, which a delimiter ends if {@code isOpen}. */
    DicomDataSet(DicomBytes bytes, int from, int to, boolean isOpen, DicomDataSet around) {
        this.bytes = bytes;
        depth = around == null ? 0 : around.depth + 1;
        bytes.walk(from, to, isOpen, depth, elements);
        boolean isStated = has(DicomTag.SPECIFIC_CHARACTER_SET);
        Charset outer = around == null ? StandardCharsets.ISO_8859_1 : around.charset;
        charset = isStated ? DicomCharsets.of(string(DicomTag.SPECIFIC_CHARACTER_SET)) : outer;
    }

    /** Name of the file, for messages. */
    public String file() {
        return bytes.file();
    }

    DicomBytes bytes() {
        return bytes;
    }

    Optional<DicomElement> element(DicomTag tag) {
        return Optional.ofNullable(elements.get(tag.number()));
    }

    /** Whether the element is there and not empty. */
    public boolean has(DicomTag tag) {
        DicomElement element = elements.get(tag.number());
        return element != null && element.length() > 0;
    }

    /** An exception about the value of an element. */
    public BadInputException badInput(DicomTag tag, String problem) {
        return BadInputException.at(file(), tag.place(), problem);
    }

    private DicomElement required(DicomTag tag) {
        if (!has(tag)) {
            throw new BadInputException(file() + ": found no " + tag.place() + ", expected one");
        }
        return elements.get(tag.number());
    }

    /**
     * Text without the padding at its end.
     *
     * @throws BadInputException if the element is missing or empty
     */
    public String text(DicomTag tag) {
        required(tag);
        return string(tag);
    }

    /** Text, or {@code absent} where the element is missing or empty. */
    public String text(DicomTag tag, String absent) {
        return has(tag) ? string(tag) : absent;
    }

    private String string(DicomTag tag) {
        DicomElement element = elements.get(tag.number());
        byte[] content = new byte[element.length()];
        bytes.bytes().get(element.offset(), content);
        // The name of the character set is itself read before the set is known.
        Charset used = charset == null ? StandardCharsets.ISO_8859_1 : charset;
        return DicomCharsets.text(content, used).replace('\0', ' ').strip();
    }

    /**
     * One whole number.
     *
     * @throws BadInputException if the element is missing, or not a whole number from {@code min} to {@code max}
     */
    public int whole(DicomTag tag, int min, int max) {
        double number = numbers(tag, 1)[0];
        if (number != Math.rint(number) || number < min || number > max) {
            throw badInput(tag, "found " + number + ", expected a whole number from " + min + " to " + max);
        }
        return (int) number;
    }

    /** One number, or {@code absent} where the element is missing or empty. */
    public double number(DicomTag tag, double absent) {
        return has(tag) ? numbers(tag, 1)[0] : absent;
    }

    /**
     * Finite numbers.
     *
     * @throws BadInputException if the element is missing or holds another number of numbers
     */
    public double[] numbers(DicomTag tag, int count) {
        double[] numbers = numbers(tag);
        if (numbers.length != count) {
            throw badInput(tag, "found " + numbers.length + " numbers, expected " + count);
        }
        return numbers;
    }

    /** Any number of finite numbers. */
    public double[] numbers(DicomTag tag) {
        DicomElement element = required(tag);
        String stated = element.representation();
        String representation = stated.isEmpty() || stated.equals("UN") ? tag.representation() : stated;
        int size =
                switch (representation) {
                    case "US" -> Short.BYTES;
                    case "UL", "FL" -> Integer.BYTES;
                    case "FD" -> Double.BYTES;
                    case "DS", "IS" -> 0;
                    default -> throw badInput(tag, "found text or bytes (" + representation + "), expected numbers");
                };
        if (size == 0) {
            return decimals(tag);
        }
        double[] numbers = new double[element.length() / size];
        for (int n = 0; n < numbers.length; n++) {
            int at = element.offset() + n * size;
            numbers[n] = switch (representation) {
                case "US" -> bytes.bytes().getShort(at) & 0xFFFF;
                case "UL" -> bytes.bytes().getInt(at) & 0xFFFFFFFFL;
                case "FL" -> bytes.bytes().getFloat(at);
                default -> bytes.bytes().getDouble(at);
            };
            if (!Double.isFinite(numbers[n])) {
                throw badInput(tag, "found " + numbers[n] + ", expected finite numbers");
            }
        }
        return numbers;
    }

    private double[] decimals(DicomTag tag) {
        String[] words = string(tag).split("\\\\", -1);
        double[] numbers = new double[words.length];
        for (int n = 0; n < words.length; n++) {
            String word = words[n].strip();
            numbers[n] = Numbers.parse(word)
                    .orElseThrow(() -> badInput(tag, "found " + Numbers.quote(word) + ", expected a number"));
        }
        return numbers;
    }

    /** Items of a sequence; none if it is missing. */
    public List<DicomDataSet> items(DicomTag tag) {
        DicomElement element = elements.get(tag.number());
        if (element == null) {
            return List.of();
        }
        DicomBytes inside = element.representation().equals("UN") ? bytes.implicit() : bytes;
        List<DicomDataSet> items = new ArrayList<>();
        inside.items(
                element.offset(),
                element.end(),
                depth,
                (from, to, isOpen) -> items.add(new DicomDataSet(inside, from, to, isOpen, this)));
        return items;
    }

    /** The first item of a sequence, if there is one. */
    public Optional<DicomDataSet> first(DicomTag tag) {
        List<DicomDataSet> items = items(tag);
        return items.isEmpty() ? Optional.empty() : Optional.of(items.get(0));
    }
}
