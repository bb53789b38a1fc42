{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Source.Diagnostic
-- Description : What can be wrong with a scene, as data
--
-- A mistake in a file is a value: one constructor per kind of mistake, carrying what a person needs to know of it.
-- Nothing is fatal. The texts stand in "Dioptre.Source.Message", in two languages; what they look like on a terminal,
-- in a log and in JSON stands in "Dioptre.Source.Report".
module Dioptre.Source.Diagnostic
  ( -- * Diagnostics
    Diagnostic (..),
    Severity (..),
    severity,
    needsMending,
    code,
    keptInFull,

    -- * What is wrong
    Problem (..),
    PassedOver (..),

    -- * Values
    Expectation (..),
    Range (..),
    Refusal (..),
    Guess (..),
    Instead (..),

    -- * Objects
    Flaw (..),
    Fate (..),
    CurveFlaw (..),
    FaceFlaw (..),
    Coordinates (..),
    Attribute (..),

    -- * Files
    FileUse (..),
    FileTrouble (..),
    PictureFault (..),
  )
where

import Data.Text (Text)
import Dioptre.Source.Departure (Departure, departureCode)
import Dioptre.Source.Span (Span)

-- | Something to say about a place in a file.
data Diagnostic = Diagnostic
  { diagnosticSpan :: Span,
    diagnosticProblem :: Problem
  }
  deriving stock (Eq, Show)

-- | How much it matters. An error is a text that does not mean what it says; a warning is a picture that may not be the
-- one that was meant; a note is for information. @check@ and @--strict@ fail on errors and warnings.
data Severity = Note | Warning | Error
  deriving stock (Eq, Ord, Show)

-- | One constructor per kind of mistake. Names of words and objects are given as they are written in the file.
data Problem
  = -- | A word that the language does not have; the words that may stand here; the one that may have been meant; what is passed over.
    UnknownWord Text [Text] (Maybe Text) PassedOver
  | -- | A word of the language where it says nothing; the object it stands in (none at the level of the file); the words that may stand there.
    MisplacedWord Text (Maybe Text) [Text] PassedOver
  | -- | An @end@ where nothing is open.
    StrayEnd Text
  | -- | A word that is taken for @end@.
    MisspeltEnd Text
  | -- | An object that is never closed: what it is, and the word and line that closed it (none: the end of the file).
    MissingEnd Text (Maybe (Text, Int))
  | -- | A block comment that is never closed.
    UnclosedComment
  | -- | What stands behind the word that opens an object and looks as if it were to be read: that word, and what it begins with.
    BehindOpening Text Text
  | -- | A value that cannot be used: of which property, why, what was expected, what is used instead.
    RefusedValue Text Refusal Expectation Instead
  | -- | A property given more often than it can be: which, and how often it can.
    RepeatedProperty Text Int
  | -- | A second shape in an object that has one.
    SecondShape Text
  | -- | An object that its values do not make: what, why, and what becomes of it.
    ImpossibleObject Text Flaw Fate
  | -- | A number that stops at a comma with digits behind it: the property, and the number that was read.
    DecimalComma Text Text
  | -- | A primitive that does not name its material.
    NoMaterialName
  | -- | A primitive whose material is not in the scene; a name that may have been meant.
    MissingMaterial Text (Maybe Text)
  | -- | A material whose name is taken: the name, and the line of the one that counts.
    RepeatedMaterial Text Int
  | -- | A camera, viewport or raytracer that replaces an earlier one: what, and the earlier one's line.
    ReplacedObject Text Int
  | -- | A model that names no file.
    NoModelFile
  | -- | A model whose file, by its name, is in none of the formats that are read.
    UnknownModelFormat Text
  | -- | A model whose file has nothing to draw in it, neither shape nor triangle nor another model: its name.
    EmptyModel Text
  | -- | A model that would hold itself: the files that name one another, from the one that is named again up to here.
    ModelCycle [FilePath]
  | -- | A model that would make models in models deeper than that.
    ModelTooDeep Text Int
  | -- | A model with which there would be more shapes to draw than that, each counted as often as it is seen.
    TooManyParts Text Integer
  | -- | A model that states another @uv_format@ than the one that its file has already.
    DifferingUvFormat Text Text
  | -- | A curve of three rows of numbers that cannot be drawn, and why.
    BrokenCurve CurveFlaw
  | -- | So many pieces of curves lead nowhere, as they end in the point where they start.
    PiecesWithoutLength Int
  | -- | A vertex, texture coordinate or normal of an OBJ file that cannot be read: which of them, and why.
    BadCoordinates Coordinates Refusal
  | -- | A face of an OBJ file that cannot be read, and why.
    BadFace FaceFlaw
  | -- | A face with a vertex that is not there: its number as written, and how many vertices stand before.
    MissingVertex Text Int
  | -- | A face with a texture coordinate or normal that is not there: which, its number as written, and how many stand before.
    MissingAttribute Attribute Text Int
  | -- | Faces that name texture coordinates or normals of which none stands before: which, and how many faces.
    NoAttributes Attribute Int
  | -- | So many triangles of a model have their corners on one line.
    CollinearTriangles Int
  | -- | A line of a model with more bytes than that, or that goes on in very many others.
    LongLine Int
  | -- | A model that names more material libraries than that.
    TooManyLibraries Int
  | -- | A material that the faces of a model name and that none of its libraries has.
    UnknownMaterialOfModel Text
  | -- | So many more faults are in the file than are told.
    MoreFaults Int
  | -- | A file that the scene names and that cannot be used: its name, what it is for, and what is the matter.
    UnusableFile Text FileUse FileTrouble
  | -- | Several rays through the very same point of each pixel.
    SamplingWithoutRandom Int
  | -- | A place of a scene that the original program takes otherwise, and how. It is told only where that is asked for.
    Departs Departure
  deriving stock (Eq, Show)

-- | What is left unread because of a mistake.
data PassedOver
  = -- | The one line.
    TheLine
  | -- | An object, whole, down to that line, which is a later one.
    TheObject Int
  | -- | An object of which there is nothing but the line that opens it.
    TheOpening
  deriving stock (Eq, Show)

-- | What a property wants.
data Expectation
  = ARealNumber Range
  | AnInteger Range
  | -- | Three real numbers.
    AVector
  | -- | Three real numbers, none of them zero.
    AVectorWithoutZero
  | -- | Three real numbers that make a vector at least 1e-10 long.
    ADirection
  | -- | Two real numbers.
    TwoCoordinates
  | -- | A name, or three or four real numbers from 0 up.
    AColour [Text]
  | ABoolean
  | -- | One of these words, or its number counted from 0.
    AChoice [Text]
  | -- | Text up to the end of the line.
    SomeText
  | -- | The name of a file to write, in the working directory.
    AnOutputName
  | -- | The same, ending in this.
    AnOutputNameEnding Text
  | -- | Red, green and blue, or one number for all three, from 0 up.
    AmountsOfLight
  deriving stock (Eq, Show)

-- | The numbers that a property admits, both ends included. They are written as the language writes numbers.
data Range
  = AnyNumber
  | AtLeast Text
  | Between Text Text
  deriving stock (Eq, Show)

-- | Why a value cannot be used.
data Refusal
  = -- | The line ends before the value.
    NothingThere
  | NotANumber Text
  | NotAnInteger Text
  | -- | A number of a magnitude above 1e100, or an integer beyond 32 bits.
    TooLarge Text
  | OutOfRange Text
  | -- | So many values were expected, so many found; and what may be the reason.
    WrongCount Int Int Guess
  | -- | The name of a colour with more behind it than an alpha, so that it stands where a number would; and what may be
    -- the reason.
    NameAmongNumbers Text Guess
  | -- | A word that is not one of those; the one that may have been meant.
    NoSuchChoice Text (Maybe Text)
  | -- | A name that would lead out of the working directory, or that holds a control character.
    UnsafeName
  | -- | A name that another file bears already.
    NameTaken
  | -- | A name with another ending.
    WrongEnding
  | -- | A direction without one.
    ZeroVector
  | -- | A scale factor of zero.
    ZeroComponent
  | -- | A point that was given already.
    SamePoint
  deriving stock (Eq, Show)

-- | Why there may be too many values.
data Guess
  = NoGuess
  | -- | One of the values begins a comment.
    CommentBehind
  | -- | This word, an @end@, stands behind the values.
    EndBehind Text
  | -- | A comma stands between two digits.
    CommaInNumber
  | -- | One of the values is a sign such as @=@.
    SignsAround
  deriving stock (Eq, Show)

-- | What a property has when its value cannot be used.
data Instead
  = -- | What it has where nothing is said of it: there is no way to write that.
    TheDefault
  | -- | This value, as the language writes it.
    Kept Text
  deriving stock (Eq, Show)

-- | What becomes of an object that is impossible.
data Fate
  = -- | The scene goes without it.
    LeftOut
  | -- | The scene keeps the one before it or, where there is none, the default.
    Superseded
  deriving stock (Eq, Show)

-- | Why an object cannot be what it says.
data Flaw
  = -- | There is no shape in it.
    WithoutShape
  | -- | It has no extent.
    ZeroSize
  | -- | The normal is shorter than that.
    ZeroNormal Double
  | -- | The camera's position and what it looks at are nearer than 1e-10.
    NowhereToLook
  | -- | The camera's (or light's) up is parallel to its front.
    UpAlongFront
  | -- | The far clipping plane is nearer than the near one.
    FarBeforeNear
  | -- | The three corners lie on one line.
    CollinearPoints
  | -- | The two ends of an axis are one point.
    EqualPoints
  | -- | The inner radius is greater than the outer one.
    InnerBeyondOuter
  | -- | A sphere of that curvature does not reach the rim.
    CurvatureBelowRadius
  | -- | The two faces of the lens meet inside the rim.
    LensTooThin
  | -- | The light has no direction: its orientation is shorter than that.
    ZeroOrientation Double
  | -- | The three attenuators are zero.
    NoAttenuation
  | -- | The wavelength is not visible: it is outside of these, in nanometres.
    InvisibleWavelength Double Double
  | -- | The picture has more pixels than that.
    TooManyPixels Int
  | -- | The light has more sources than that.
    TooManyOscillators Int
  deriving stock (Eq, Show)

-- | Why three rows of numbers make no curve.
data CurveFlaw
  = -- | So many of the three rows are not there.
    RowsMissing Int
  | -- | A row has so many numbers, where the one of x has so many.
    RowsDiffer Int Int
  | -- | A number in it cannot be used.
    RowRefused Refusal
  deriving stock (Eq, Show)

-- | Why a line is not a face.
data FaceFlaw
  = -- | A corner that is none.
    NotACorner Text
  | -- | A corner that has other parts than the first one: it, and the first.
    OtherForm Text Text
  | -- | A face has at least three corners, this one has so many.
    TooFewCorners Int
  deriving stock (Eq, Show)

-- | What the numbers of a line of an OBJ file are.
data Coordinates
  = OfVertex
  | OfAttribute Attribute
  deriving stock (Eq, Show)

-- | What a corner of a face can have beside its vertex.
data Attribute
  = TextureCoordinate
  | Normal
  deriving stock (Eq, Show)

-- | What a file that a scene or a model names is for.
data FileUse
  = ForTexture
  | ForMask
  | ForModel
  | ForMaterialLibrary
  deriving stock (Eq, Show)

-- | What is the matter with a file.
data FileTrouble
  = -- | There is none of that name in these folders; one of them that may have been meant.
    NoSuchFile [FilePath] (Maybe Text)
  | -- | There are several.
    SeveralFiles [FilePath]
  | -- | There is one, but it cannot be read, in the words of who tried.
    Unreadable Text
  | -- | There is one, but it is no picture that can be read, and why.
    Undecodable PictureFault
  deriving stock (Eq, Show)

-- | Why a file is no picture that can be read.
data PictureFault
  = -- | It is in none of the formats.
    NoPicture
  | -- | It says that it has so many pixels, which are too many, or more than it can have.
    ClaimsPixels Integer
  | -- | It has fewer pixels than it says.
    FewerPixels
  | -- | It does not say what its pixels are.
    NoHeader
  | -- | It ends in the middle.
    CutOff
  | -- | It has no image in it, or one without pixels.
    NoImage
  | -- | The codes of a GIF have more bits than GIF has.
    LongCodes
  | -- | Decoding it takes too much memory.
    TooMuchMemory
  | -- | Its decoder did not get through.
    Damaged
  deriving stock (Eq, Show)

-- | How much a problem matters.
--
-- Spec: check.severity.
severity :: Problem -> Severity
severity = \case
  UnknownWord {} -> Error
  MisplacedWord {} -> Error
  StrayEnd {} -> Error
  MisspeltEnd {} -> Error
  MissingEnd {} -> Error
  UnclosedComment -> Error
  BehindOpening {} -> Warning
  RefusedValue {} -> Error
  RepeatedProperty {} -> Error
  SecondShape {} -> Error
  ImpossibleObject {} -> Error
  DecimalComma {} -> Warning
  NoMaterialName -> Note
  MissingMaterial {} -> Warning
  RepeatedMaterial {} -> Warning
  ReplacedObject {} -> Note
  NoModelFile -> Warning
  UnknownModelFormat {} -> Error
  EmptyModel {} -> Warning
  ModelCycle {} -> Error
  ModelTooDeep {} -> Error
  TooManyParts {} -> Error
  DifferingUvFormat {} -> Warning
  BrokenCurve {} -> Error
  PiecesWithoutLength {} -> Warning
  BadCoordinates {} -> Error
  BadFace {} -> Error
  MissingVertex {} -> Error
  MissingAttribute {} -> Warning
  NoAttributes {} -> Note
  CollinearTriangles {} -> Note
  LongLine {} -> Error
  TooManyLibraries {} -> Error
  UnknownMaterialOfModel {} -> Warning
  MoreFaults {} -> Warning
  UnusableFile {} -> Error
  SamplingWithoutRandom {} -> Warning
  Departs {} -> Note

-- | Whether it is more than a note, so that @check@ and @--strict@ fail.
needsMending :: Diagnostic -> Bool
needsMending d = severity (diagnosticProblem d) >= Warning

-- | The stable name of a kind of problem, for programs.
--
-- >>> code UnclosedComment
-- "unclosed-comment"
code :: Problem -> Text
code = \case
  UnknownWord {} -> "unknown-word"
  MisplacedWord {} -> "misplaced-word"
  StrayEnd {} -> "stray-end"
  MisspeltEnd {} -> "misspelt-end"
  MissingEnd {} -> "missing-end"
  UnclosedComment -> "unclosed-comment"
  BehindOpening {} -> "behind-opening"
  RefusedValue _ refusal _ _ -> refusalCode refusal
  RepeatedProperty {} -> "repeated-property"
  SecondShape {} -> "second-shape"
  ImpossibleObject _ flaw _ -> flawCode flaw
  DecimalComma {} -> "decimal-comma"
  NoMaterialName -> "no-material-name"
  MissingMaterial {} -> "missing-material"
  RepeatedMaterial {} -> "repeated-material"
  ReplacedObject {} -> "replaced-object"
  NoModelFile -> "no-model-file"
  UnknownModelFormat {} -> "unknown-model-format"
  EmptyModel {} -> "empty-model"
  ModelCycle {} -> "model-cycle"
  ModelTooDeep {} -> "model-too-deep"
  TooManyParts {} -> "too-many-parts"
  DifferingUvFormat {} -> "differing-uv-format"
  BrokenCurve flaw -> case flaw of
    RowsMissing _ -> "missing-rows"
    RowsDiffer {} -> "unequal-rows"
    RowRefused refusal -> refusalCode refusal
  PiecesWithoutLength {} -> "pieces-without-length"
  BadCoordinates _ refusal -> refusalCode refusal
  BadFace flaw -> case flaw of
    NotACorner _ -> "bad-face"
    OtherForm {} -> "mixed-face"
    TooFewCorners _ -> "short-face"
  MissingVertex {} -> "missing-vertex"
  MissingAttribute {} -> "missing-attribute"
  NoAttributes {} -> "no-attributes"
  CollinearTriangles {} -> "collinear-triangles"
  LongLine {} -> "long-line"
  TooManyLibraries {} -> "too-many-libraries"
  UnknownMaterialOfModel {} -> "unknown-material-of-model"
  MoreFaults {} -> "more-faults"
  UnusableFile _ _ trouble -> case trouble of
    NoSuchFile {} -> "missing-file"
    SeveralFiles _ -> "several-files"
    Unreadable _ -> "unreadable-file"
    Undecodable _ -> "unreadable-file"
  SamplingWithoutRandom {} -> "sampling-without-random"
  Departs departure -> departureCode departure

-- | A file with very many faults has so many told, and the number of the others.
keptInFull :: Int
keptInFull = 20

refusalCode :: Refusal -> Text
refusalCode = \case
  NothingThere -> "missing-value"
  NotANumber {} -> "not-a-number"
  NameAmongNumbers {} -> "not-a-number"
  NotAnInteger {} -> "not-an-integer"
  TooLarge {} -> "number-too-large"
  OutOfRange {} -> "out-of-range"
  WrongCount {} -> "wrong-count"
  NoSuchChoice {} -> "unknown-choice"
  UnsafeName -> "unsafe-name"
  NameTaken -> "name-taken"
  WrongEnding -> "wrong-ending"
  ZeroVector -> "zero-vector"
  ZeroComponent -> "zero-component"
  SamePoint -> "same-point"

flawCode :: Flaw -> Text
flawCode = \case
  WithoutShape -> "no-shape"
  ZeroSize -> "zero-size"
  ZeroNormal {} -> "zero-normal"
  NowhereToLook -> "nowhere-to-look"
  UpAlongFront -> "up-along-front"
  FarBeforeNear -> "far-before-near"
  CollinearPoints -> "collinear-points"
  EqualPoints -> "equal-points"
  InnerBeyondOuter -> "inner-beyond-outer"
  CurvatureBelowRadius -> "curvature-below-radius"
  LensTooThin -> "lens-too-thin"
  ZeroOrientation {} -> "zero-orientation"
  NoAttenuation -> "no-attenuation"
  InvisibleWavelength {} -> "invisible-wavelength"
  TooManyPixels {} -> "too-many-pixels"
  TooManyOscillators {} -> "too-many-oscillators"
