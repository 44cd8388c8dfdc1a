package wbv.recording.signals;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Optional;
import java.util.zip.Deflater;
import us.hebi.matlab.mat.format.Mat5;
import us.hebi.matlab.mat.format.Mat5File;
import us.hebi.matlab.mat.types.Array;
import us.hebi.matlab.mat.types.MatFile.Entry;
import us.hebi.matlab.mat.types.Matrix;
import us.hebi.matlab.mat.types.Sinks;
import us.hebi.matlab.mat.types.Source;
import us.hebi.matlab.mat.types.Sources;
import us.hebi.matlab.mat.types.Struct;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/**
 * MATLAB's files of versions 5 to 7, by MFL. Channels are variables named {@code head_acc_z}, since a name in MATLAB has no dots; {@code t}
 * is the time [s], {@code fs} a rate [Hz]. Fields of a struct are signals too. Written uncompressed, as version 6: noise hardly compresses,
 * and MFL would need all of it in memory once more.
 */
final class MatFile {

    /** Letters of a name in MATLAB ({@code namelengthmax}). */
    private static final int LONGEST_NAME = 63;

    private MatFile() {}

    static SignalFile read(String file, InputStream content) throws IOException {
        MatrixColumns columns = new MatrixColumns(file, true);
        try (Source source = Sources.wrapInputStream(content)) {
            for (Entry entry : Mat5.newReader(source).readMat().getEntries()) {
                add(columns, entry.getName(), entry.getValue());
            }
        } catch (IOException | RuntimeException damaged) {
            throw DataFault.in(file, "is a damaged MAT file, or cut off; save or copy it again", damaged);
        }
        return columns.signals();
    }

    private static void add(MatrixColumns columns, String name, Array array) {
        if (array instanceof Matrix matrix && !matrix.isComplex() && matrix.getNumDimensions() == 2) {
            columns.add(name, matrix.getNumRows(), matrix.getNumCols(), matrix::getDouble, Optional.empty());
        } else if (array instanceof Struct struct && struct.getNumElements() == 1) {
            for (String field : struct.getFieldNames()) {
                add(columns, name + "." + field, struct.get(field));
            }
        } else if (!name.isEmpty()) {
            columns.addOther(name);
        }
    }

    static void write(SampledColumns columns, OutputStream out) throws IOException {
        Mat5File mat = Mat5.newMatFile();
        Matrix time = Mat5.newMatrix(columns.length(), 1);
        for (int i = 0; i < columns.length(); i++) {
            time.setDouble(i, columns.time(i));
        }
        mat.addArray("t", time);
        for (int j = 0; j < columns.channels().size(); j++) {
            Channel channel = columns.channels().get(j);
            String name = channel.toString().replace('.', '_');
            if (name.length() > LONGEST_NAME) {
                throw DataFault.in(columns.file(), "'" + name + "' is longer than the " + LONGEST_NAME
                        + " letters of a name in MATLAB; give the place a shorter one");
            }
            Matrix values = Mat5.newMatrix(columns.length(), 1);
            for (int i = 0; i < columns.length(); i++) {
                values.setDouble(i, columns.value(j, i));
            }
            mat.addArray(name, values);
        }
        Mat5.newWriter(Sinks.wrapNonSeeking(out)).setDeflateLevel(Deflater.NO_COMPRESSION).writeMat(mat).flush();
    }
}
