{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Syntax.Keyword
-- Description : The words of the scene language
--
-- Every word that scenes and configurations may use, with all its spellings: the first is the one that the program
-- writes, the others are read too. Case does not matter. The type is a closed sum, so that a new word lights up every
-- place that must know it. The constructors are meant to be imported qualified: @Keyword.Sphere@.
module Dioptre.Syntax.Keyword
  ( -- * Words
    Keyword (..),
    spelling,
    spellings,
    fromSpelling,
    allSpellings,

    -- * What a word does
    Role (..),
    role,
    isShape,
  )
where

import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.List.NonEmpty as NonEmpty
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text

-- | A word of the language, whatever its spelling.
data Keyword
  = End
  | -- Objects of the scene
    Camera
  | Viewport
  | Raytracer
  | Primitive
  | Material
  | TextureMaterial
  | AmbientLight
  | DirectionalLight
  | PointLight
  | LinearApertureLight
  | RectangularApertureLight
  | EllipticalApertureLight
  | ApertureMaskLight
  | Model
  | -- Shapes
    Sphere
  | Plane
  | Disk
  | Annulus
  | Triangle
  | SmoothTriangle
  | Tube
  | Cylinder
  | Cone
  | Cube
  | SphericalCap
  | Lens
  | Torus
  | Geometry
  | -- Objects that nothing reads in a scene
    TextureComparator
  | ViewFrustum
  | DefaultMaterial
  | Scene
  | ModelMsr
  | ConsoleComparator
  | Particle
  | ParticlesSystem
  | -- Properties of objects
    Position
  | LookAt
  | Up
  | Width
  | Height
  | Angle
  | NearClippingPlane
  | FarClippingPlane
  | ImageFileName
  | Ray
  | InnerRay
  | Name
  | MaterialName
  | Color
  | ConstantAttenuator
  | LinearAttenuator
  | QuadraticAttenuator
  | Orientation
  | Normal
  | Ka
  | Kd
  | Ks
  | Kr
  | Kt
  | Plasticity
  | RefractiveIndex
  | Shininess
  | Point
  | Task
  | Sampling
  | Seed
  | RecursiveLevel
  | ReflexionAlgorithm
  | PixelCoordinate
  | Space
  | ColorNormalization
  | Scale
  | Rotation
  | Translation
  | File
  | Uv
  | UvFormat
  | TextureKa
  | TextureKd
  | TextureKs
  | Size
  | Curvature
  | MajorRadius
  | MinorRadius
  | WaveLength
  | PeriodIteration
  | NbOscillator
  | Front
  | Amplification
  | Mask
  | ElectricCharge
  | -- Properties of the configuration
    Application
  | ReadData
  | WriteData
  | LogFileName
  | LogConsole
  | LogFile
  | ViewportImageCount
  | Language
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The spelling that the program writes.
--
-- Spec: canonical.words.
spelling :: Keyword -> Text
spelling = NonEmpty.head . spellings

-- | Every spelling, in lower case; the first is the one that the program writes.
--
-- >>> spellings Ray
-- "ray" :| ["rayon"]
--
-- Spec: word.roles, shape.words.
spellings :: Keyword -> NonEmpty Text
spellings = \case
  End -> "end" :| ["fin"]
  Camera -> "camera" :| []
  Viewport -> "viewport" :| []
  Raytracer -> "raytracer" :| []
  Primitive -> "primitive" :| []
  Material -> "material" :| ["materiel", "color_material", "blinn_material"]
  TextureMaterial -> "texture_material" :| ["texture_materiel"]
  AmbientLight -> "ambient_light" :| ["lumiere_ambiante"]
  DirectionalLight -> "directional_light" :| ["lumiere_directionnelle"]
  PointLight -> "point_light" :| ["lumiere_ponctuelle"]
  LinearApertureLight -> "linear_aperture_light" :| []
  RectangularApertureLight -> "rectangular_aperture_light" :| []
  EllipticalApertureLight -> "elliptical_aperture_light" :| []
  ApertureMaskLight -> "aperture_mask_light" :| []
  Model -> "model" :| []
  Sphere -> "sphere" :| []
  Plane -> "plane" :| ["plan"]
  Disk -> "disk" :| ["disque"]
  Annulus -> "annulus" :| ["anneau"]
  Triangle -> "triangle" :| []
  SmoothTriangle -> "btriangle" :| []
  Tube -> "tube" :| []
  Cylinder -> "cylinder" :| ["cylindre"]
  Cone -> "cone" :| []
  Cube -> "cube" :| []
  SphericalCap -> "spherical_cap" :| ["calotte_spherique"]
  Lens -> "lens" :| ["lentille"]
  Torus -> "torus" :| ["tore"]
  Geometry -> "geometry" :| ["geometrie"]
  TextureComparator -> "texture_comparator" :| ["texture_comparateur"]
  ViewFrustum -> "view_frustum" :| ["viewfrustum"]
  DefaultMaterial -> "default_material" :| []
  Scene -> "scene" :| []
  ModelMsr -> "model_msr" :| []
  ConsoleComparator -> "console_comparator" :| ["comparateur_console"]
  Particle -> "particle" :| ["particule"]
  ParticlesSystem -> "particles_system" :| ["systeme_particules"]
  Position -> "position" :| []
  LookAt -> "look_at" :| []
  Up -> "up" :| ["haut"]
  Width -> "width" :| ["largeur"]
  Height -> "height" :| ["hauteur"]
  Angle -> "angle" :| []
  NearClippingPlane -> "near_clipping_plane" :| []
  FarClippingPlane -> "far_clipping_plane" :| []
  ImageFileName -> "image_file_name" :| ["nom_fichier_image"]
  Ray -> "ray" :| ["rayon"]
  InnerRay -> "inner_ray" :| ["rayon_interieur"]
  Name -> "name" :| ["nom"]
  MaterialName -> "material_name" :| ["nom_materiel"]
  Color -> "color" :| ["couleur"]
  ConstantAttenuator -> "constant_attenuator" :| []
  LinearAttenuator -> "linear_attenuator" :| []
  QuadraticAttenuator -> "quadratic_attenuator" :| []
  Orientation -> "orientation" :| []
  Normal -> "normal" :| ["normale"]
  Ka -> "ka" :| []
  Kd -> "kd" :| []
  Ks -> "ks" :| []
  Kr -> "kr" :| []
  Kt -> "kt" :| []
  Plasticity -> "plasticity" :| ["p"]
  RefractiveIndex -> "refractive_index" :| ["n"]
  Shininess -> "shininess" :| ["brillance"]
  Point -> "point" :| []
  Task -> "task" :| []
  Sampling -> "sampling" :| []
  Seed -> "seed" :| ["graine"]
  RecursiveLevel -> "recursive_level" :| []
  ReflexionAlgorithm -> "reflexion_algorithm" :| ["algorithme_reflexion"]
  PixelCoordinate -> "pixel_coordinate" :| ["coordonnee_pixel"]
  Space -> "space" :| ["espace"]
  ColorNormalization -> "color_normalization" :| []
  Scale -> "scale" :| ["homothetie"]
  Rotation -> "rotation" :| []
  Translation -> "translation" :| []
  File -> "file" :| ["fichier"]
  Uv -> "uv" :| []
  UvFormat -> "uv_format" :| []
  TextureKa -> "texture_ka" :| []
  TextureKd -> "texture_kd" :| []
  TextureKs -> "texture_ks" :| []
  Size -> "size" :| ["taille"]
  Curvature -> "curvature" :| ["courbure"]
  MajorRadius -> "major_radius" :| []
  MinorRadius -> "minor_radius" :| []
  WaveLength -> "wave_length" :| ["longueur_onde"]
  PeriodIteration -> "period_iteration" :| []
  NbOscillator -> "nb_oscillator" :| []
  Front -> "front" :| ["devant"]
  Amplification -> "amplification" :| []
  Mask -> "mask" :| ["masque"]
  ElectricCharge -> "electric_charge" :| ["charge_electrique"]
  Application -> "application" :| []
  ReadData -> "read_data" :| ["read_scene"]
  WriteData -> "write_data" :| ["write_scene"]
  LogFileName -> "log_file_name" :| []
  LogConsole -> "log_console" :| []
  LogFile -> "log_file" :| []
  ViewportImageCount -> "viewport_image_count" :| []
  Language -> "language" :| ["langue"]

-- | The word that is spelt so, in any case; 'Nothing' for a word that is none of the language's.
--
-- >>> fromSpelling "RAYON"
-- Just Ray
--
-- Spec: line.case.
fromSpelling :: Text -> Maybe Keyword
fromSpelling text = Map.lookup (Text.toLower text) dictionary

-- | Every spelling of every word, in alphabetical order.
allSpellings :: [Text]
allSpellings = Map.keys dictionary

dictionary :: Map Text Keyword
dictionary = Map.fromList [(s, k) | k <- [minBound .. maxBound], s <- NonEmpty.toList (spellings k)]

-- | What a word does to the structure of a file.
data Role
  = -- | Closes the innermost open object.
    Closes
  | -- | Opens an object of the scene, and closes whatever is open.
    OpensInScene
  | -- | Opens an object inside another.
    OpensInside
  | -- | Names a property, whose value follows on the line.
    NamesProperty
  deriving stock (Eq, Show)

-- | The role of a word.
--
-- Spec: word.roles.
role :: Keyword -> Role
role k
  | k == End = Closes
  | k <= Model = OpensInScene
  | k <= ParticlesSystem = OpensInside
  | otherwise = NamesProperty

-- | Whether a word opens a shape.
isShape :: Keyword -> Bool
isShape k = k >= Sphere && k <= Geometry
